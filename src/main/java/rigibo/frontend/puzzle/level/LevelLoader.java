package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Document;
import rigibo.frontend.document.FormatRule;
import rigibo.frontend.document.JsonSchema;
import rigibo.frontend.document.Problems;

import java.nio.file.Path;
import java.util.Optional;

/**
 * Reads level files and reports all problems of a file at once. Exceptions are files that are not
 * JSON or were made for a newer game, where further messages would mislead, and files with more
 * problems than anyone reads.
 */
public final class LevelLoader {

    /** The newest format this version reads; it reads all before it. */
    static final int FORMAT = 2;

    private final JsonSchema schema = new JsonSchema(LevelShelf.SCHEMA);

    /** Reads a file; a file that cannot be read is a problem like any other. */
    public LoadedLevel load(Path file) {
        Problems problems = new Problems(file.toString());
        return loaded(Document.read(file, problems), problems);
    }

    /**
     * Reads a text.
     *
     * @param name of the text in messages
     */
    public LoadedLevel parse(String name, String text) {
        Problems problems = new Problems(name);
        return loaded(Document.parse(text, problems), problems);
    }

    private LoadedLevel loaded(Optional<Document> document, Problems problems) {
        return new LoadedLevel(document.flatMap(this::read), document, problems);
    }

    private Optional<Level> read(Document document) {
        if (FormatRule.isNewer(document, FORMAT)) {
            return Optional.empty();
        }
        if (!schema.admits(document)) {
            return Optional.empty();
        }
        FormatRules.check(document);
        LevelSketch sketch = LevelSketch.of(document);
        IdRules.check(sketch);
        StartRules.check(sketch);
        ApartRules.check(sketch);
        PieceRules.check(sketch);
        PathRules.check(sketch);
        JointRules.check(sketch);
        EffectRules.check(sketch);
        SolutionRules.check(sketch);
        StarRules.check(sketch);
        return document.hasErrors() ? Optional.empty() : Optional.of(sketch.level());
    }
}
