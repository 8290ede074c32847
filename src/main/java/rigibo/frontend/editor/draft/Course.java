package rigibo.frontend.editor.draft;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;

/**
 * The path along which a body is driven, or the lack of one. Edits return the changed body.
 *
 * @param body whose path it is
 */
public record Course(Item body) {

    /** Most stops of a path in a level file. */
    private static final int MOST = 16;

    private static final String PATH = "path";
    private static final String POINTS = "points";

    /** From one stop to one that is added, m. */
    private static final Point FURTHER = new Point(1, 0);

    private static final double USUAL_SPEED = 1;

    /** Whether the body has a path. */
    public boolean isThere() {
        return body.node().path(PATH).isObject();
    }

    /** The stops after the start, m. */
    public List<Point> stops() {
        List<Point> stops = new ArrayList<>();
        for (JsonNode point : body.node().path(PATH).path(POINTS)) {
            stops.add(new Point(Decimal.read(point.path(0), 0), Decimal.read(point.path(1), 0)));
        }
        return stops;
    }

    /** The body's behaviour at the last stop. */
    public String end() {
        return body.node().path(PATH).path("end").asString("back");
    }

    /** Returns the body with a path, which drives it, or fixed and without one. */
    public Item switched() {
        ObjectNode changed = JsonNodeFactory.instance.objectNode();
        changed.setAll(body.node());
        if (isThere()) {
            changed.remove(PATH);
            changed.put("dynamic", false);
        } else {
            changed.remove(List.of("dynamic", "vx", "vy", "spin"));
            ObjectNode path = changed.putObject(PATH);
            path.putArray(POINTS).add(JointEntry.node(body.place().plus(FURTHER.times(2))));
            path.put("speed", USUAL_SPEED);
        }
        return new Item(body.pointer(), changed);
    }

    /** Returns the body with one more stop, beside the last one. */
    public Item longer() {
        List<Point> stops = stops();
        if (stops.size() < MOST) {
            Point last = stops.isEmpty() ? body.place() : stops.get(stops.size() - 1);
            stops.add(last.plus(FURTHER));
        }
        return with(stops);
    }

    /** Returns the body without its last stop, unless it is the only one. */
    public Item shorter() {
        List<Point> stops = stops();
        if (stops.size() > 1) {
            stops.remove(stops.size() - 1);
        }
        return with(stops);
    }

    /** Returns the body with a stop at another place. */
    public Item moved(int stop, Point place) {
        List<Point> stops = stops();
        stops.set(stop, place);
        return with(stops);
    }

    private Item with(List<Point> stops) {
        ArrayNode points = JsonNodeFactory.instance.arrayNode();
        stops.forEach(stop -> points.add(JointEntry.node(stop)));
        return with(POINTS, points);
    }

    /** Returns the body with another behaviour at the last stop. */
    public Item ending(String end) {
        return with("end", JsonNodeFactory.instance.stringNode(end));
    }

    private Item with(String member, JsonNode value) {
        ObjectNode path = JsonNodeFactory.instance.objectNode();
        path.setAll((ObjectNode) body.node().path(PATH));
        path.set(member, value);
        return body.with(PATH, path);
    }
}
