package rigibo.frontend.puzzle.level;

import java.nio.file.Path;
import java.util.Optional;

/**
 * Reads level files. Everything wrong with a file is told at once, unless it is no JSON at all or
 * made for a newer game, where every further message would mislead.
 */
public final class LevelLoader {

    /** The format this version reads. */
    static final int FORMAT = 1;

    private final JsonSchema schema = new JsonSchema(LevelShelf.SCHEMA);

    /** Reads a file; what cannot be read is a problem like any other. */
    public LoadedLevel load(Path file) {
        Problems problems = new Problems(file.toString());
        return FileText.read(file, problems)
                .map(text -> parse(text, problems))
                .orElseGet(() -> new LoadedLevel(Optional.empty(), Optional.empty(), problems));
    }

    /**
     * Reads a text.
     *
     * @param name what messages call it
     */
    public LoadedLevel parse(String name, String text) {
        return parse(text, new Problems(name));
    }

    private LoadedLevel parse(String text, Problems problems) {
        Optional<LocatedJson> json = JsonParsing.parse(text, problems);
        return new LoadedLevel(json.flatMap(found -> read(found, problems)), json, problems);
    }

    private Optional<Level> read(LocatedJson json, Problems problems) {
        if (FormatRule.isNewer(json, FORMAT, problems)) {
            return Optional.empty();
        }
        schema.check(json, problems);
        LevelSketch sketch = LevelSketch.of(json, problems);
        IdRules.check(sketch, problems);
        StartRules.check(sketch, problems);
        PieceRules.check(sketch, problems);
        EffectRules.check(sketch, problems);
        SolutionRules.check(sketch, problems);
        return problems.hasErrors() ? Optional.empty() : Optional.of(sketch.level());
    }
}
