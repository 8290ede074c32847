package rigibo.frontend.puzzle.replay;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.Correction;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.ImpactSearch;
import rigibo.backend.setup.Integrator;
import rigibo.frontend.document.Cause;
import rigibo.frontend.document.Document;
import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.Origin;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Checkpoint;

import tools.jackson.databind.JsonNode;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.regex.Pattern;

/** Reads the parts of a replay that the schema accepts, and reports impossible values. */
final class ReplaySketch {

    private static final Pattern STEP = Pattern.compile("0|[1-9]\\d{0,7}");

    /** Pointer of the origin of its level. */
    static final String MADE = "/level/made";

    private final Document json;

    ReplaySketch(Document json) {
        this.json = json;
    }

    /** The hash at a pointer; empty after its error was reported. */
    OptionalLong hash(String pointer) {
        JsonNode node = json.node(pointer);
        OptionalLong hash = Hex.read(node.asString(""));
        if (node.isString() && hash.isEmpty()) {
            error(pointer, "must be 16 hexadecimal digits, was " + node);
        }
        return hash;
    }

    /**
     * The origin of its level; empty if the level was not made by chance, or if the origin has an
     * error.
     */
    Optional<Origin> origin() {
        JsonNode made = json.node(MADE);
        return made.isMissingNode() || json.isSpoilt(MADE)
                ? Optional.empty()
                : Optional.of(
                        new Origin(made.path("seed").asLong(0), made.path("generator").asInt(0)));
    }

    /** The checkpoints in the order of their steps, whatever their order in the file. */
    List<Checkpoint> checkpoints() {
        String all = "/hashes";
        List<Checkpoint> checkpoints = new ArrayList<>();
        for (String step : json.node(all).propertyNames()) {
            String pointer = all + "/" + step;
            if (!STEP.matcher(step).matches()) {
                error(all, "\"" + step + "\" is no number of steps");
            } else if (Integer.parseInt(step) > Recording.MOST_STEPS) {
                error(pointer, beyond());
            } else {
                hash(pointer)
                        .ifPresent(
                                hash ->
                                        checkpoints.add(
                                                new Checkpoint(Integer.parseInt(step), hash)));
            }
        }
        if (json.node(all).isObject() && json.node(all).isEmpty()) {
            error(all, "is empty: nothing tells whether it plays back the same");
        }
        checkpoints.sort(Comparator.comparingInt(Checkpoint::step));
        return checkpoints;
    }

    private static String beyond() {
        return "is beyond the " + Recording.MOST_STEPS + " steps of an hour, the most we play";
    }

    /**
     * The clicks; they must be in the order of time, and none after the end.
     *
     * @param end the last step
     */
    List<Act> acts(int end) {
        List<Act> acts = new ArrayList<>();
        int before = 0;
        for (int i = 0; i < json.node("/clicks").size(); i++) {
            String pointer = "/clicks/" + i + "/step";
            JsonNode node = json.node(pointer);
            int step = json.isSpoilt(pointer) ? before : (int) node.asDouble(before);
            if (step < before) {
                error(pointer, "is before the click at step " + before);
            } else if (step >= end) {
                error(pointer, "is not before the end, which is at step " + end);
            }
            before = Math.max(before, step);
            acts.add(new Act(step, Click.targetIn(json.node("/clicks/" + i))));
        }
        return acts;
    }

    /** The accuracy of the simulation; must be called only if the schema accepts it. */
    Accuracy accuracy() {
        JsonNode node = json.node("/accuracy");
        return new Accuracy(
                node.path("substeps").asInt(),
                node.path("velocityIterations").asInt(),
                ImpactMode.valueOf(node.path("impacts").asString()),
                node.path("impactTolerance").asDouble(),
                ImpactSearch.valueOf(node.path("search").asString()),
                node.path("maxImpactsPerPair").asInt(),
                Integrator.valueOf(node.path("integrator").asString()),
                ContactSolver.valueOf(node.path("contactSolver").asString()),
                Correction.valueOf(node.path("correction").asString()));
    }

    private void error(String pointer, String message) {
        json.error(Cause.CONTENT, pointer, () -> message);
    }
}
