package rigibo.frontend.puzzle.replay;

import rigibo.frontend.puzzle.level.FileText;
import rigibo.frontend.puzzle.level.FormatRule;
import rigibo.frontend.puzzle.level.JsonParsing;
import rigibo.frontend.puzzle.level.JsonSchema;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LocatedJson;
import rigibo.frontend.puzzle.level.Problems;
import rigibo.frontend.puzzle.level.Suggestion;
import rigibo.frontend.puzzle.rules.Checkpoint;
import rigibo.frontend.puzzle.rules.Deletion;
import rigibo.frontend.puzzle.rules.Replay;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * Reads replay files. Everything that is wrong with one is told at once; a replay of another
 * version, of another level or of one that was altered since would play to something else, and is
 * refused.
 */
public final class ReplayLoader {

    /** The format this version reads and writes. */
    static final int FORMAT = 1;

    private static final String SCHEMA = "/rigibo/replay.schema.json";

    private final JsonSchema schema = new JsonSchema(SCHEMA);
    private final List<Level> levels;

    /** A loader of replays of these levels. */
    public ReplayLoader(List<Level> levels) {
        this.levels = List.copyOf(levels);
    }

    /** Reads a file; what cannot be read is a problem like any other. */
    public LoadedReplay load(Path file) {
        Problems problems = new Problems(file.toString());
        return loaded(FileText.read(file, problems), problems);
    }

    /**
     * Reads a text.
     *
     * @param name what messages call it
     */
    LoadedReplay parse(String name, String text) {
        return loaded(Optional.of(text), new Problems(name));
    }

    private LoadedReplay loaded(Optional<String> text, Problems problems) {
        Optional<Recording> recording =
                text.flatMap(words -> JsonParsing.parse(words, problems))
                        .flatMap(json -> read(json, problems));
        return new LoadedReplay(recording, problems.inOrder());
    }

    private Optional<Recording> read(LocatedJson json, Problems problems) {
        if (FormatRule.isNewer(json, FORMAT, problems)) {
            return Optional.empty();
        }
        schema.check(json, problems);
        ReplaySketch sketch = new ReplaySketch(json, problems);
        requireThisVersion(json, problems);
        Optional<Level> level = level(json, problems);
        OptionalLong hash = sketch.hash("/level/hash");
        level.ifPresent(found -> requireUnaltered(found, hash, json, problems));
        List<Checkpoint> checkpoints = sketch.checkpoints();
        int end = checkpoints.isEmpty() ? Integer.MAX_VALUE : last(checkpoints).step();
        List<Deletion> deletions = sketch.deletions(end);
        if (problems.hasErrors()) {
            return Optional.empty();
        }
        Replay replay = new Replay(hash.orElseThrow(), deletions, sketch.accuracy());
        return Optional.of(new Recording(level.orElseThrow(), replay, checkpoints));
    }

    private static Checkpoint last(List<Checkpoint> checkpoints) {
        return checkpoints.get(checkpoints.size() - 1);
    }

    private static void requireThisVersion(LocatedJson json, Problems problems) {
        String pointer = "/game";
        String version = json.node(pointer).asString("");
        String present = GameVersion.present();
        if (json.node(pointer).isString() && !version.equals(present)) {
            problems.error(
                    json.at(pointer),
                    pointer,
                    "was played in RigiBo "
                            + version
                            + "; this is "
                            + present
                            + ", in which bodies may move otherwise");
        }
    }

    private Optional<Level> level(LocatedJson json, Problems problems) {
        String pointer = "/level/id";
        String id = json.node(pointer).asString("");
        Optional<Level> level = levels.stream().filter(one -> one.id().equals(id)).findFirst();
        if (json.node(pointer).isString() && level.isEmpty()) {
            List<String> ids = levels.stream().map(Level::id).toList();
            problems.error(
                    json.at(pointer),
                    pointer,
                    "belongs to the level \""
                            + id
                            + "\", which is not here"
                            + Suggestion.among(ids, id));
        }
        return level;
    }

    private static void requireUnaltered(
            Level level, OptionalLong hash, LocatedJson json, Problems problems) {
        if (hash.isPresent() && hash.getAsLong() != level.hash()) {
            String pointer = "/level/hash";
            problems.error(
                    json.at(pointer),
                    pointer,
                    "the level \""
                            + level.id()
                            + "\" was altered since this was played: its hash is "
                            + Hex.of(level.hash())
                            + " now, and was "
                            + Hex.of(hash.getAsLong()));
        }
    }
}
