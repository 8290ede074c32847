package rigibo.frontend.editor.draft;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Shape;

import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.List;
import java.util.Optional;

/**
 * A disc about its middle.
 *
 * @param radius m
 */
public record Disc(double radius) implements Form {

    @Override
    public List<Point> corners() {
        return List.of();
    }

    @Override
    public boolean contains(Point point) {
        return point.length() <= radius;
    }

    @Override
    public double reach() {
        return radius;
    }

    @Override
    public Optional<Shape> shape() {
        return radius > 0 ? Optional.of(new Circle(radius)) : Optional.empty();
    }

    @Override
    public ObjectNode node() {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put("type", "circle");
        node.set("r", Decimal.of(radius));
        return node;
    }
}
