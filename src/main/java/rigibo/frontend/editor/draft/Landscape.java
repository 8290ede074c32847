package rigibo.frontend.editor.draft;

import rigibo.backend.geometry.Shape;
import rigibo.frontend.puzzle.level.Outline;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * A landscape: edges from point to point, with matter to the left of the way and air to the right.
 *
 * @param corners m
 * @param isLoop whether the last point leads to the first one
 */
public record Landscape(List<Point> corners, boolean isLoop) implements Form {

    /** Fewest and most points in a level file. */
    public static final int FEWEST = 2;

    public static final int MOST = 256;

    /** Distance within which a point counts as on an edge, m. */
    private static final double NEAR = 0.2;

    public Landscape {
        corners = List.copyOf(corners);
    }

    /** An open landscape with its matter below, from whichever end it was drawn. */
    public static Landscape ground(List<Point> points) {
        Landscape drawn = new Landscape(points, false);
        boolean runsRight = points.get(points.size() - 1).x() > points.get(0).x();
        return runsRight ? drawn.turnedOver() : drawn;
    }

    /** A loop with its matter inside, or around it if it is drawn about a point, such as a ball. */
    public static Landscape loop(List<Point> points, Point air) {
        Corners outline = new Corners(points);
        Landscape solid = new Landscape(outline.counterClockwise(), true);
        return outline.contains(air) ? solid.turnedOver() : solid;
    }

    /** A body's {@code shape}. */
    static Landscape of(JsonNode shape) {
        return new Landscape(
                Corners.of(shape.path("points")).corners(), shape.path("loop").asBoolean(false));
    }

    /** Returns this landscape with matter and air exchanged. */
    public Landscape turnedOver() {
        List<Point> back = new ArrayList<>(corners);
        Collections.reverse(back);
        return new Landscape(back, isLoop);
    }

    @Override
    public boolean isOpen() {
        return !isLoop;
    }

    @Override
    public boolean isLandscape() {
        return true;
    }

    /** A line has no inside, so it is grabbed where it can be seen. */
    @Override
    public boolean contains(Point point) {
        int edges = isLoop ? corners.size() : corners.size() - 1;
        for (int i = 0; i < edges; i++) {
            Point from = corners.get(i);
            if (point.isNear(from, corners.get((i + 1) % corners.size()), NEAR)) {
                return true;
            }
        }
        return false;
    }

    @Override
    public double reach() {
        return corners.stream().mapToDouble(Point::length).max().orElse(0);
    }

    @Override
    public Optional<Shape> shape() {
        try {
            return Optional.of(Outline.of(node()).shape());
        } catch (IllegalArgumentException refused) {
            // Edges that cross are shown as an outline, beside the loader's message.
            return Optional.empty();
        }
    }

    /** Returns this landscape with a point at another place. */
    public Landscape with(int point, Point place) {
        return new Landscape(new Corners(corners).with(point, place).corners(), isLoop);
    }

    @Override
    public ObjectNode node() {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put("type", "chain");
        ArrayNode points = node.putArray("points");
        corners.forEach(corner -> points.add(JointEntry.node(corner)));
        if (isLoop) {
            node.put("loop", true);
        }
        return node;
    }
}
