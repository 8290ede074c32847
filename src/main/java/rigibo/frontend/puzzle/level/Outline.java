package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;

import tools.jackson.databind.JsonNode;

import java.util.ArrayList;
import java.util.List;

/**
 * A shape as a file states it. The engine places a shape by its centre of mass, a file by a point
 * of the author's choice; the offset between the two converts one to the other.
 *
 * @param shape about its centre of mass
 * @param centroidX m, in the file's frame
 * @param centroidY m, in the file's frame
 */
public record Outline(Shape shape, double centroidX, double centroidY) {

    /**
     * The engine's shape of a {@code shape} node.
     *
     * @throws IllegalArgumentException when the engine refuses it, with the engine's message
     */
    public static Outline of(JsonNode node) {
        return switch (node.path("type").asString("")) {
            case "box" -> new Outline(box(node), 0, 0);
            case "circle" -> new Outline(new Circle(number(node, "r")), 0, 0);
            case "capsule" ->
                    new Outline(new Capsule(number(node, "length") / 2, number(node, "r")), 0, 0);
            case "chain" -> new Outline(chain(node), 0, 0);
            case "compound" -> compound(node.path("parts"));
            default -> polygon(node.path("points"));
        };
    }

    private static double number(JsonNode node, String name) {
        return node.path(name).asDouble(0);
    }

    private static Polygon box(JsonNode node) {
        double round = number(node, "round");
        double width = number(node, "w") - 2 * round;
        double height = number(node, "h") - 2 * round;
        Polygon box = Polygon.box(width, height);
        return round == 0 ? box : box.rounded(round);
    }

    private static Chain chain(JsonNode node) {
        JsonNode points = node.path("points");
        double[] xy = new double[2 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            xy[2 * i] = points.path(i).path(0).asDouble(0);
            xy[2 * i + 1] = points.path(i).path(1).asDouble(0);
        }
        return node.path("loop").asBoolean(false) ? Chain.loop(xy) : Chain.open(xy);
    }

    private static Outline compound(JsonNode stated) {
        List<Part> parts = new ArrayList<>();
        for (JsonNode part : stated) {
            parts.add(part(part));
        }
        Compound compound = Compound.of(parts);
        return new Outline(compound, compound.centroidX(), compound.centroidY());
    }

    private static Part part(JsonNode node) {
        Outline own = of(node.path("shape"));
        if (!(own.shape instanceof Convex convex)) {
            throw new IllegalArgumentException("a part must be in one piece");
        }
        double angle = Angle.ofDegrees(number(node, "angle"));
        double cos = Angle.cos(angle);
        double sin = Angle.sin(angle);
        return Part.of(convex)
                .at(
                        number(node, "x") + cos * own.centroidX - sin * own.centroidY,
                        number(node, "y") + sin * own.centroidX + cos * own.centroidY)
                .angle(angle);
    }

    /** A polygon; its corners may be in either order. */
    private static Outline polygon(JsonNode points) {
        int count = points.size();
        double[] xy = new double[2 * count];
        boolean isForwards = signedArea(points) > 0;
        for (int i = 0; i < count; i++) {
            JsonNode point = points.path(isForwards ? i : count - 1 - i);
            xy[2 * i] = point.path(0).asDouble(0);
            xy[2 * i + 1] = point.path(1).asDouble(0);
        }
        Polygon polygon = Polygon.of(xy);
        return new Outline(polygon, xy[0] - polygon.cornerX(0), xy[1] - polygon.cornerY(0));
    }

    /** Shoelace sum, m²; positive counter-clockwise. */
    static double signedArea(JsonNode points) {
        double twice = 0;
        for (int i = 0; i < points.size(); i++) {
            JsonNode from = points.path(i);
            JsonNode to = points.path((i + 1) % points.size());
            twice += from.path(0).asDouble(0) * to.path(1).asDouble(0);
            twice -= to.path(0).asDouble(0) * from.path(1).asDouble(0);
        }
        return twice / 2;
    }
}
