package rigibo.frontend.editor;

import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.NewLevel;
import rigibo.frontend.editor.file.DraftFile;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.scene.Key;

import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.List;
import java.util.Optional;

/** A level of two boxes in the air, and what tests do with it. */
final class TwoBoxes {

    private TwoBoxes() {}

    /** Two boxes in the air, one over the other: rigibo1 at (4, 6), rigibo2 at (4, 4). */
    static Author withTwoBoxes() {
        return withTwoBoxes("en");
    }

    static Author withTwoBoxes(String language) {
        Draft draft = NewLevel.draft();
        for (double y : new double[] {6, 4}) {
            draft = draft.plus(box(4, y));
        }
        return new Author(new DraftFile(draft, Optional.empty()), Optional.empty(), language);
    }

    static ObjectNode box(double x, double y) {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.putObject("shape").put("type", "box").put("w", 1.0).put("h", 1.0);
        return node.put("x", x)
                .put("y", y)
                .put("material", "rigibo")
                .put("dynamic", true)
                .put("deletable", true);
    }

    static Author joined(LevelJoint.Type type) {
        Author author = withTwoBoxes();
        author.take(type);
        author.clickWorld(4.2, 5.8);
        author.clickWorld(4.3, 4.2);
        author.take(Author.SELECT);
        return author;
    }

    static List<String> problems(Author author) {
        return new LevelLoader()
                .parse("draft", author.draft().toString()).problems().stream()
                        .map(problem -> problem.pointer() + " " + problem.message())
                        .toList();
    }

    static void erase(Author author, int letters) {
        for (int i = 0; i < letters; i++) {
            author.scene.keyPressed(Key.BACKSPACE);
        }
    }
}
