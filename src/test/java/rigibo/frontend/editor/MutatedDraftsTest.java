package rigibo.frontend.editor;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.document.Mutations;
import rigibo.frontend.editor.desk.Leaf;
import rigibo.frontend.editor.file.DraftFile;
import rigibo.frontend.editor.file.Unsaved;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.scene.Key;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** A draft that was left unsaved and then damaged ended the editor as soon as it was taken up. */
@Execution(ExecutionMode.CONCURRENT)
class MutatedDraftsTest {

    private static final String BOX = "{\"type\": \"box\", \"w\": 0.5, \"h\": 4}";

    private static final String TRIANGLE =
            "{\"type\": \"polygon\", \"points\": [[0, 0], [1, 0], [0, 1]]}";

    private static final String CAPSULE = "{\"type\": \"capsule\", \"length\": 1, \"r\": 0.2}";

    private static final String COMPOUND =
            "{\"type\": \"compound\", \"parts\":"
                    + " [{\"shape\": {\"type\": \"circle\", \"r\": 0.3}, \"x\": 0.5}]}";

    private static final String CHAIN =
            "{\"type\": \"chain\", \"points\": [[1, 0], [-1, 0]], \"loop\": false}";

    @TempDir Path folder;

    @Test
    void noValueOfAnyPartIsWorseThanADraftSetAside() {
        String level =
                LevelTexts.with(BOX, TRIANGLE)
                        .replace("\"radius\"", "\"material\": \"ice\", \"radius\"");
        Mutations.someOf("{\"file\": \"a.json\", \"level\": " + level + "}")
                .forEach(this::assertTakenUpOrSetAside);
    }

    @ParameterizedTest
    @ValueSource(strings = {CAPSULE, COMPOUND, CHAIN})
    void noValueOfAShapePathOrFanEndsTheEditor(String shape) {
        String more =
                ", \"path\": {\"points\": [[1, 2]], \"speed\": 1},"
                        + " \"fan\": {\"width\": 1, \"reach\": 2, \"force\": 9}";
        String level = LevelTexts.with(BOX, shape + more);
        Mutations.someOf("{\"file\": \"a.json\", \"level\": " + level + "}")
                .forEach(this::assertTakenUpOrSetAside);
    }

    private void assertTakenUpOrSetAside(String mutated) {
        String shown = mutated.substring(0, Math.min(1500, mutated.length()));
        Path kept = folder.resolve("1.unsaved.json");
        try {
            Files.writeString(kept, mutated);
            Unsaved unsaved = new Unsaved(folder);
            Optional<DraftFile> left = unsaved.last().map(Unsaved.Left::left);
            boolean isNewer = mutated.contains("\"format\":9e15");
            assertThat(left.isPresent() || isNewer)
                    .as(shown)
                    .isEqualTo(unsaved.trouble().isEmpty());
            assertThat(Files.exists(kept)).as(shown).isEqualTo(unsaved.trouble().isEmpty());
            left.ifPresent(draft -> use(draft, shown));
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    private static void use(DraftFile draft, String shown) {
        try {
            Author author = new Author(draft, Optional.empty(), "en");
            assertThat(author.look().texts()).as(shown).isNotEmpty();
            for (Leaf leaf : Leaf.OF_BODY) {
                author.scene.keyPressed(Key.TAB);
                author.turnTo(leaf);
                author.look();
            }
        } catch (RuntimeException ended) {
            throw new AssertionError(shown, ended);
        }
    }
}
