package rigibo.frontend.editor.draft;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Shape;

import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A capsule about its middle, along its own x axis.
 *
 * @param length between the middles of its ends, m
 * @param radius of its ends, m
 */
public record Pill(double length, double radius) implements Form {

    /** Radius of a new one, m. */
    public static final double USUAL = 0.2;

    /** Corners by which each round end is drawn. */
    private static final int CORNERS = 9;

    @Override
    public List<Point> corners() {
        List<Point> corners = new ArrayList<>();
        for (int side = 1; side >= -1; side -= 2) {
            Point end = end(side);
            for (int i = 0; i < CORNERS; i++) {
                double degrees = -90.0 + 180.0 * i / (CORNERS - 1) + (side > 0 ? 0 : 180);
                corners.add(end.plus(new Point(radius, 0).turned(degrees)));
            }
        }
        return corners;
    }

    /** Middle of the right end (1) or the left one (−1), m. */
    public Point end(int side) {
        return new Point(side * length / 2, 0);
    }

    @Override
    public boolean contains(Point point) {
        double along = Math.max(-length / 2, Math.min(length / 2, point.x()));
        return point.minus(new Point(along, 0)).length() <= radius;
    }

    @Override
    public double reach() {
        return length / 2 + radius;
    }

    @Override
    public Optional<Shape> shape() {
        boolean isSound = radius > 0 && length >= 0;
        return isSound ? Optional.of(new Capsule(length / 2, radius)) : Optional.empty();
    }

    @Override
    public ObjectNode node() {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put("type", "capsule");
        node.set("length", Decimal.of(length));
        node.set("r", Decimal.of(radius));
        return node;
    }
}
