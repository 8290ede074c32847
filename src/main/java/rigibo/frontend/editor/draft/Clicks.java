package rigibo.frontend.editor.draft;

import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.Solution;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;

/** The stored solutions of a draft, and that of its star. */
public final class Clicks {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final String POINTER = "/solutions";
    private static final String STAR = "/star";

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

    /** Clicks as a level file states a solution. */
    static JsonNode node(Draft draft, Solution solution) {
        Set<String> joints = JointEntry.ids(draft);
        ArrayNode clicks = NODES.arrayNode();
        for (Click click : solution.clicks()) {
            ObjectNode node = clicks.addObject();
            node.set("t", Decimal.of(click.seconds()));
            node.put(joints.contains(click.target()) ? JOINT : BODY, click.target());
        }
        return NODES.objectNode().set("clicks", clicks);
    }

    /** Returns the draft with a body renamed in all solutions, joints and the star. */
    public static Draft renamed(Draft draft, String before, String after) {
        return renamed(Joinery.renamed(draft, before, after), BODY, before, after);
    }

    /** Returns the draft with a joint renamed in all solutions and the star. */
    public static Draft jointRenamed(Draft draft, String before, String after) {
        return renamed(draft, JOINT, before, after);
    }

    private static Draft renamed(Draft draft, String kind, String before, String after) {
        Draft renamed = draft;
        for (String clicks : lists(draft)) {
            for (int i = 0; i < draft.at(clicks).size(); i++) {
                renamed = renamedAt(renamed, clicks + "/" + i + "/" + kind, before, after);
            }
        }
        return renamedAt(renamed, STAR + "/" + kind, before, after);
    }

    private static Draft renamedAt(Draft draft, String pointer, String before, String after) {
        return draft.at(pointer).asString("").equals(before)
                ? draft.with(pointer, NODES.stringNode(after))
                : draft;
    }

    /** Pointers of the clicks of all solutions, the star's among them. */
    private static List<String> lists(Draft draft) {
        List<String> lists = new ArrayList<>();
        for (int i = 0; i < draft.at(POINTER).size(); i++) {
            lists.add(POINTER + "/" + i + "/clicks");
        }
        lists.add(STAR + "/solution/clicks");
        return lists;
    }

    /**
     * Returns the draft without the solutions that click a body, and without a star about it.
     *
     * @param body its id; empty of a ball, which nothing names
     */
    static Draft forget(Draft draft, String body) {
        return body.isEmpty()
                ? draft
                : keepWhere(draft, click -> !Click.targetIn(click).equals(body));
    }

    /**
     * Returns the draft without the solutions and the star that need a joint which is not there.
     */
    static Draft forgetJoints(Draft draft) {
        Set<String> ids = JointEntry.ids(draft);
        return keepWhere(
                draft, click -> !click.has(JOINT) || ids.contains(click.path(JOINT).asString("")));
    }

    /**
     * Keeps the solutions of which every click passes. A star names its target as a click does, and
     * stays if it passes, too.
     */
    private static Draft keepWhere(Draft draft, Predicate<JsonNode> passes) {
        ArrayNode kept = NODES.arrayNode();
        for (JsonNode solution : draft.at(POINTER)) {
            if (clicks(solution).allMatch(passes)) {
                kept.add(solution);
            }
        }
        boolean isWhole = kept.size() == draft.at(POINTER).size();
        Draft rest = isWhole ? draft : draft.with(POINTER, kept);
        JsonNode star = draft.at(STAR);
        boolean staysStar = passes.test(star) && clicks(star.path("solution")).allMatch(passes);
        return staysStar ? rest : rest.without(STAR);
    }

    private static List<String> targets(JsonNode solution) {
        return clicks(solution).map(Click::targetIn).toList();
    }

    private static Stream<JsonNode> clicks(JsonNode solution) {
        return StreamSupport.stream(solution.path("clicks").spliterator(), false);
    }
}
