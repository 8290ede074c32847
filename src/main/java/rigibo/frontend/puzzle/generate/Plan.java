package rigibo.frontend.puzzle.generate;

import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Length;
import rigibo.frontend.puzzle.level.Substance;

import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;

/**
 * A level in the making. Parts are placed in a frame in which the ball rolls to the right; after
 * {@link #turn} the frame is mirrored.
 */
final class Plan {

    /** Size of the world, m. */
    static final double WIDTH = 9;

    static final double HEIGHT = 10;

    /** Thickness of slabs, m. */
    static final double SLAB = 0.3;

    /** Numbers in the file are rounded to this part of a metre or degree. */
    private static final double PER_UNIT = 1000;

    private final ObjectNode document = JsonNodeFactory.instance.objectNode();
    private final List<ObjectNode> bodies = new ArrayList<>();
    private final List<String> preparing = new ArrayList<>();
    private final List<String> releasing = new ArrayList<>();
    private final double radius;
    private final Substance ground;
    private int stones;
    private boolean isMirrored;

    /**
     * A plan without parts.
     *
     * @param radius of the ball, m
     * @param ground substance of all bodies that never move
     */
    Plan(double radius, Substance ground) {
        this.radius = radius;
        this.ground = ground;
    }

    /** Radius of the ball, m. */
    double radius() {
        return radius;
    }

    /** Mirrors the frame: from here on the ball rolls the other way. */
    void turn() {
        isMirrored = !isMirrored;
    }

    void ball(double x, double y) {
        ObjectNode ball = document.putObject("ball");
        place(ball, x, y);
        ball.put("radius", radius).put("material", Substance.BALL.title());
    }

    /** Adds the platform, by the middle of its upper surface. */
    void platform(double x, double top, double width) {
        double height = 0.3;
        ObjectNode platform = document.putObject("platform");
        place(platform, x, top - height / 2);
        platform.put("w", rounded(width)).put("h", height);
    }

    /** Adds a box that never moves. */
    void stone(double left, double bottom, double right, double top) {
        fixed(upright("stone" + ++stones, left, bottom, right, top));
    }

    /** Adds a slab that never moves, by the ends of its upper surface. */
    void slope(Spot from, Spot to) {
        double halfX = (to.x() - from.x()) / 2;
        double halfY = (to.y() - from.y()) / 2;
        Spot middle = from.plus(halfX, halfY);
        double[] corners = {
            -halfX, -halfY - SLAB, halfX, halfY - SLAB, halfX, halfY, -halfX, -halfY
        };
        fixed(polygon("stone" + ++stones, middle, corners));
    }

    private void fixed(ObjectNode body) {
        body.put("material", ground.title()).put("dynamic", false);
    }

    /** Adds a box that a click deletes; returns its id. */
    String box(String role, double left, double bottom, double right, double top) {
        String id = free(role);
        deletable(upright(id, left, bottom, right, top));
        return id;
    }

    /** Adds a board that a click deletes, by the ends of its lower surface; returns its id. */
    String board(String role, Spot from, Spot to, double thickness) {
        String id = free(role);
        double angle = Angle.atan2(to.y() - from.y(), to.x() - from.x());
        double x = (from.x() + to.x()) / 2 - Angle.sin(angle) * thickness / 2;
        double y = (from.y() + to.y()) / 2 + Angle.cos(angle) * thickness / 2;
        double length = Length.hypot(to.x() - from.x(), to.y() - from.y());
        ObjectNode board = rectangle(id, x, y, length, thickness);
        double degrees = rounded(Angle.inDegrees(angle));
        board.put("angle", isMirrored ? -degrees : degrees);
        deletable(board);
        return id;
    }

    private static void deletable(ObjectNode body) {
        body.put("material", Substance.RIGIBO.title()).put("deletable", true);
    }

    /** Adds a box that moves and that no click deletes. */
    void load(Substance made, double left, double bottom, double right, double top) {
        upright(free("load"), left, bottom, right, top).put("material", made.title());
    }

    /** Adds a convex body of stone that moves, by its corners about a point. */
    void wedge(Spot at, double... corners) {
        polygon(free("wedge"), at, corners).put("material", Substance.STONE.title());
    }

    /** A role with a number, from the second body of that role on. */
    private String free(String role) {
        long same = bodies.stream().filter(body -> isOf(body, role)).count();
        return same == 0 ? role : role + (same + 1);
    }

    private static boolean isOf(ObjectNode body, String role) {
        return body.path("id").asString().replaceAll("\\d+$", "").equals(role);
    }

    private ObjectNode upright(String id, double left, double bottom, double right, double top) {
        return rectangle(id, (left + right) / 2, (bottom + top) / 2, right - left, top - bottom);
    }

    private ObjectNode rectangle(String id, double x, double y, double width, double height) {
        ObjectNode body = body(id);
        body.putObject("shape")
                .put("type", "box")
                .put("w", rounded(width))
                .put("h", rounded(height));
        place(body, x, y);
        return body;
    }

    private ObjectNode polygon(String id, Spot at, double... corners) {
        ObjectNode body = body(id);
        ArrayNode points = body.putObject("shape").put("type", "polygon").putArray("points");
        for (int i = 0; i < corners.length; i += 2) {
            double x = isMirrored ? -corners[i] : corners[i];
            points.addArray().add(rounded(x)).add(rounded(corners[i + 1]));
        }
        place(body, at.x(), at.y());
        return body;
    }

    private ObjectNode body(String id) {
        ObjectNode body = JsonNodeFactory.instance.objectNode().put("id", id);
        bodies.add(body);
        return body;
    }

    private void place(ObjectNode part, double x, double y) {
        part.put("x", rounded(isMirrored ? WIDTH - x : x)).put("y", rounded(y));
    }

    private static double rounded(double value) {
        return Math.round(value * PER_UNIT) / PER_UNIT;
    }

    /** States a click that must come before the ball moves. */
    void prepares(String id) {
        preparing.add(id);
    }

    /** States a click that releases the ball, after those stated before. */
    void releases(String id) {
        releasing.add(id);
    }

    /** Number of boxes and boards that a click deletes. */
    int boxes() {
        return (int) bodies.stream().filter(body -> body.has("deletable")).count();
    }

    /** The clicks that should win, in a winning order. */
    List<String> clicks() {
        List<String> clicks = new ArrayList<>(preparing);
        clicks.addAll(releasing);
        return clicks;
    }

    /** The parts placed so far: the members {@code ball}, {@code platform} and {@code bodies}. */
    ObjectNode document() {
        ObjectNode placed = document.deepCopy();
        placed.putArray("bodies").addAll(bodies);
        return placed;
    }
}
