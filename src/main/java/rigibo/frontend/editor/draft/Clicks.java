package rigibo.frontend.editor.draft;

import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.Solution;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.List;
import java.util.stream.StreamSupport;

/** The stored solutions of a draft. */
public final class Clicks {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final String POINTER = "/solutions";

    private Clicks() {}

    /**
     * Returns the draft with these clicks as a solution, in place of one that clicks the same
     * bodies.
     */
    public static Draft keep(Draft draft, Solution solution) {
        List<String> bodies = solution.clicks().stream().map(Click::body).toList();
        ArrayNode kept = NODES.arrayNode();
        for (JsonNode other : draft.at(POINTER)) {
            if (!bodies(other).equals(bodies)) {
                kept.add(other);
            }
        }
        return draft.with(POINTER, kept.add(node(solution)));
    }

    private static JsonNode node(Solution solution) {
        ArrayNode clicks = NODES.arrayNode();
        for (Click click : solution.clicks()) {
            ObjectNode node = clicks.addObject();
            node.set("t", Decimal.of(click.seconds()));
            node.put("body", click.body());
        }
        return NODES.objectNode().set("clicks", clicks);
    }

    /** Returns the draft with a body renamed in all solutions and joints. */
    public static Draft renamed(Draft draft, String before, String after) {
        Draft renamed = Joinery.renamed(draft, before, after);
        for (int i = 0; i < draft.at(POINTER).size(); i++) {
            List<String> bodies = bodies(draft.at(POINTER).path(i));
            for (int j = 0; j < bodies.size(); j++) {
                if (bodies.get(j).equals(before)) {
                    String pointer = POINTER + "/" + i + "/clicks/" + j + "/body";
                    renamed = renamed.with(pointer, NODES.stringNode(after));
                }
            }
        }
        return renamed;
    }

    /** Returns the draft without the solutions that click a body. */
    static Draft forget(Draft draft, String body) {
        ArrayNode kept = NODES.arrayNode();
        for (JsonNode solution : draft.at(POINTER)) {
            if (!bodies(solution).contains(body)) {
                kept.add(solution);
            }
        }
        return kept.size() == draft.at(POINTER).size() ? draft : draft.with(POINTER, kept);
    }

    private static List<String> bodies(JsonNode solution) {
        return StreamSupport.stream(solution.path("clicks").spliterator(), false)
                .map(click -> click.path("body").asString(""))
                .toList();
    }
}
