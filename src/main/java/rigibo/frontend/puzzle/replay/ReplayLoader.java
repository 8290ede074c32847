package rigibo.frontend.puzzle.replay;

import rigibo.backend.Pool;
import rigibo.frontend.document.Cause;
import rigibo.frontend.document.Document;
import rigibo.frontend.document.FormatRule;
import rigibo.frontend.document.JsonSchema;
import rigibo.frontend.document.Problems;
import rigibo.frontend.document.Suggestion;
import rigibo.frontend.puzzle.generate.Generator;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Origin;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Checkpoint;
import rigibo.frontend.puzzle.rules.Replay;

import tools.jackson.databind.JsonNode;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;

/**
 * Reads replay files and reports all problems of one at once. A replay of another revision of the
 * simulation, of another level or of a level that was altered since would run differently, and is
 * rejected.
 */
public final class ReplayLoader {

    /** The format this version reads and writes. */
    static final int FORMAT = 2;

    /** The format that did not state the revision of the simulation. */
    private static final int FORMAT_WITHOUT_REVISION = 1;

    private static final String REVISION = "/revision";
    private static final String SCHEMA = "/rigibo/replay.schema.json";

    private final JsonSchema schema = new JsonSchema(SCHEMA);
    private final List<Level> levels;

    /** A loader of replays of these levels. */
    public ReplayLoader(List<Level> levels) {
        this.levels = List.copyOf(levels);
    }

    /** Reads a file; a file that cannot be read is a problem like any other. */
    public LoadedReplay load(Path file) {
        Problems problems = new Problems(file.toString());
        return loaded(Document.read(file, problems), problems);
    }

    /**
     * Reads a text.
     *
     * @param name of the text in messages
     */
    public LoadedReplay parse(String name, String text) {
        Problems problems = new Problems(name);
        return loaded(Document.parse(text, problems), problems);
    }

    /**
     * The content of a document: a recording, or the origin of a level that has to be made first.
     */
    private record Found(Optional<Recording> recording, Optional<Origin> unmade) {

        static final Found NOTHING = new Found(Optional.empty(), Optional.empty());
    }

    private LoadedReplay loaded(Optional<Document> document, Problems problems) {
        Found found = document.map(this::read).orElse(Found.NOTHING);
        OptionalInt otherRevision =
                document.map(ReplayLoader::otherRevision).orElse(OptionalInt.empty());
        return new LoadedReplay(found.recording, otherRevision, found.unmade, problems.inOrder());
    }

    private Found read(Document json) {
        if (FormatRule.isNewer(json, FORMAT)) {
            return Found.NOTHING;
        }
        OptionalInt otherRevision = otherRevision(json);
        otherRevision.ifPresent(revision -> tellRevision(revision, json));
        if (isWithoutRevision(json) || !schema.admits(json)) {
            return Found.NOTHING;
        }
        ReplaySketch sketch = new ReplaySketch(json);
        Optional<Origin> origin = sketch.origin();
        Optional<Level> level = origin.isPresent() ? madeLevel(origin.get(), json) : level(json);
        OptionalLong hash = sketch.hash("/level/hash");
        level.ifPresent(found -> requireUnaltered(found, hash, json));
        List<Checkpoint> checkpoints = sketch.checkpoints();
        int end = checkpoints.isEmpty() ? Integer.MAX_VALUE : last(checkpoints).step();
        List<Act> acts = sketch.acts(end);
        if (json.hasErrors()) {
            return new Found(Optional.empty(), level.isPresent() ? Optional.empty() : origin);
        }
        Replay replay = new Replay(hash.orElseThrow(), acts, sketch.accuracy());
        return new Found(
                Optional.of(new Recording(level.orElseThrow(), replay, checkpoints)),
                Optional.empty());
    }

    private static Checkpoint last(List<Checkpoint> checkpoints) {
        return checkpoints.get(checkpoints.size() - 1);
    }

    private static boolean isWithoutRevision(Document json) {
        JsonNode format = json.node("/format");
        return format.isInt() && format.intValue() == FORMAT_WITHOUT_REVISION;
    }

    private static OptionalInt otherRevision(Document json) {
        if (isWithoutRevision(json)) {
            return OptionalInt.of(0);
        }
        JsonNode revision = json.node(REVISION);
        return revision.isInt() && revision.intValue() != Pool.REVISION
                ? OptionalInt.of(revision.intValue())
                : OptionalInt.empty();
    }

    private static void tellRevision(int revision, Document json) {
        String version = json.node("/game").asString("");
        json.error(
                Cause.OTHER_VERSION,
                isWithoutRevision(json) ? "/format" : REVISION,
                () ->
                        "was played in revision "
                                + revision
                                + " of the simulation"
                                + (version.isEmpty() ? "" : ", by RigiBo " + version)
                                + "; this is revision "
                                + Pool.REVISION
                                + ", in which bodies move otherwise: it is kept, and not played");
    }

    private Optional<Level> madeLevel(Origin origin, Document json) {
        Optional<Level> level =
                levels.stream().filter(one -> one.origin().equals(Optional.of(origin))).findFirst();
        if (level.isEmpty()) {
            boolean isOfThis = origin.generator() == Generator.VERSION;
            json.error(
                    isOfThis ? Cause.LEVEL_UNKNOWN : Cause.OTHER_VERSION,
                    ReplaySketch.MADE,
                    () ->
                            "belongs to the level of seed "
                                    + origin.seed()
                                    + (isOfThis
                                            ? ", which has to be made first: open it in the game"
                                            : otherGenerator(origin.generator())));
        }
        return level;
    }

    private static String otherGenerator(int version) {
        return " by version "
                + version
                + " of the generator; this is version "
                + Generator.VERSION
                + ", which makes another level of it";
    }

    private Optional<Level> level(Document json) {
        String pointer = "/level/id";
        String id = json.node(pointer).asString("");
        Optional<Level> level = levels.stream().filter(one -> one.id().equals(id)).findFirst();
        if (json.node(pointer).isString() && level.isEmpty()) {
            List<String> ids = levels.stream().map(Level::id).toList();
            json.error(
                    Cause.LEVEL_UNKNOWN,
                    pointer,
                    () ->
                            "belongs to the level \""
                                    + id
                                    + "\", which is not here"
                                    + Suggestion.among(ids, id));
        }
        return level;
    }

    private static void requireUnaltered(Level level, OptionalLong hash, Document json) {
        if (hash.isPresent() && hash.getAsLong() != level.hash()) {
            String pointer = "/level/hash";
            json.error(
                    Cause.LEVEL_CHANGED,
                    pointer,
                    () ->
                            "the level \""
                                    + level.id()
                                    + "\" was altered since this was played: its hash is "
                                    + Hex.of(level.hash())
                                    + " now, and was "
                                    + Hex.of(hash.getAsLong()));
        }
    }
}
