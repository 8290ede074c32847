package rigibo.frontend.editor.draft;

import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.Solution;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.StreamSupport;

/** The stored solutions of a draft. */
public final class Clicks {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final String POINTER = "/solutions";

    /** Members of a click that name its target. */
    private static final String BODY = "body";

    private static final String JOINT = "joint";

    private Clicks() {}

    /**
     * Returns the draft with these clicks as a solution, in place of one that clicks the same
     * things.
     */
    public static Draft keep(Draft draft, Solution solution) {
        List<String> targets = solution.clicks().stream().map(Click::target).toList();
        ArrayNode kept = NODES.arrayNode();
        for (JsonNode other : draft.at(POINTER)) {
            if (!targets(other).equals(targets)) {
                kept.add(other);
            }
        }
        return draft.with(POINTER, kept.add(node(draft, solution)));
    }

    private static JsonNode node(Draft draft, Solution solution) {
        Set<String> joints = JointEntry.ids(draft);
        ArrayNode clicks = NODES.arrayNode();
        for (Click click : solution.clicks()) {
            ObjectNode node = clicks.addObject();
            node.set("t", Decimal.of(click.seconds()));
            node.put(joints.contains(click.target()) ? JOINT : BODY, click.target());
        }
        return NODES.objectNode().set("clicks", clicks);
    }

    /** Returns the draft with a body renamed in all solutions and joints. */
    public static Draft renamed(Draft draft, String before, String after) {
        return renamed(Joinery.renamed(draft, before, after), BODY, before, after);
    }

    /** Returns the draft with a joint renamed in all solutions. */
    public static Draft jointRenamed(Draft draft, String before, String after) {
        return renamed(draft, JOINT, before, after);
    }

    private static Draft renamed(Draft draft, String kind, String before, String after) {
        Draft renamed = draft;
        for (int i = 0; i < draft.at(POINTER).size(); i++) {
            String clicks = POINTER + "/" + i + "/clicks";
            for (int j = 0; j < draft.at(clicks).size(); j++) {
                String pointer = clicks + "/" + j + "/" + kind;
                if (draft.at(pointer).asString("").equals(before)) {
                    renamed = renamed.with(pointer, NODES.stringNode(after));
                }
            }
        }
        return renamed;
    }

    /** Returns the draft without the solutions that click a body. */
    static Draft forget(Draft draft, String body) {
        return keepWhere(draft, solution -> !targets(solution).contains(body));
    }

    /** Returns the draft without the solutions that click a joint which is not there. */
    static Draft forgetJoints(Draft draft) {
        Set<String> ids = JointEntry.ids(draft);
        return keepWhere(draft, solution -> ids.containsAll(named(solution, JOINT)));
    }

    private static Draft keepWhere(Draft draft, Predicate<JsonNode> isKept) {
        ArrayNode kept = NODES.arrayNode();
        for (JsonNode solution : draft.at(POINTER)) {
            if (isKept.test(solution)) {
                kept.add(solution);
            }
        }
        return kept.size() == draft.at(POINTER).size() ? draft : draft.with(POINTER, kept);
    }

    private static List<String> targets(JsonNode solution) {
        return StreamSupport.stream(solution.path("clicks").spliterator(), false)
                .map(Click::targetIn)
                .toList();
    }

    private static List<String> named(JsonNode solution, String kind) {
        return StreamSupport.stream(solution.path("clicks").spliterator(), false)
                .filter(click -> click.has(kind))
                .map(click -> click.path(kind).asString(""))
                .toList();
    }
}
