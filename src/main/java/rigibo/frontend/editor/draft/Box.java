package rigibo.frontend.editor.draft;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;

import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.List;
import java.util.Optional;

/**
 * A box about its middle.
 *
 * @param width m
 * @param height m
 */
public record Box(double width, double height) implements Form {

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
        return width > 0 && height > 0 ? Optional.of(Polygon.box(width, height)) : Optional.empty();
    }

    @Override
    public ObjectNode node() {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put("type", "box");
        node.set("w", Decimal.of(width));
        node.set("h", Decimal.of(height));
        return node;
    }
}
