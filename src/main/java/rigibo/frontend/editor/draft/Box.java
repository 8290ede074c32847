package rigibo.frontend.editor.draft;

import rigibo.backend.geometry.Shape;
import rigibo.frontend.puzzle.level.Outline;

import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.List;
import java.util.Optional;

/**
 * A box about its middle.
 *
 * @param width m
 * @param height m
 * @param round radius of its corners, m; 0 for sharp ones
 */
public record Box(double width, double height, double round) implements Form {

    /** Largest radius that a level file allows, as a share of the smaller side. */
    private static final double MOST_ROUND = 0.45;

    /** A box with sharp corners. */
    public Box(double width, double height) {
        this(width, height, 0);
    }

    /** Returns this box at another size, its corners no rounder than that allows. */
    public Box sized(double wide, double high) {
        return new Box(wide, high, Math.min(round, mostRound(wide, high)));
    }

    /** Largest radius of the corners of a box, m. */
    public static double mostRound(double wide, double high) {
        return Decimal.rounded(MOST_ROUND * Math.min(wide, high));
    }

    @Override
    public List<Point> corners() {
        double x = width / 2;
        double y = height / 2;
        return List.of(new Point(-x, -y), new Point(x, -y), new Point(x, y), new Point(-x, y));
    }

    @Override
    public boolean contains(Point point) {
        return Math.abs(point.x()) <= width / 2 && Math.abs(point.y()) <= height / 2;
    }

    @Override
    public double reach() {
        return Math.hypot(width, height) / 2;
    }

    @Override
    public Optional<Shape> shape() {
        boolean isThick = Math.min(width, height) > 2 * round;
        return isThick ? Optional.of(Outline.of(node()).shape()) : Optional.empty();
    }

    @Override
    public ObjectNode node() {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put("type", "box");
        node.set("w", Decimal.of(width));
        node.set("h", Decimal.of(height));
        if (round > 0) {
            node.set("round", Decimal.of(round));
        }
        return node;
    }
}
