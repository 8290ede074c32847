package rigibo.frontend.editor.draft;

import rigibo.backend.geometry.Shape;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

import java.util.List;
import java.util.Optional;

/**
 * An outline relative to the point at which its item is placed; it may be one that cannot be
 * simulated.
 */
public sealed interface Form permits Box, Disc, Pill, Corners, Landscape, Parts {

    /** Corners in their order, m; none of a disc. */
    List<Point> corners();

    /** The lines by which it is drawn, each of corners in their order, m; none of a disc. */
    default List<List<Point>> lines() {
        return List.of(corners());
    }

    /** Whether a point lies within, m. */
    boolean contains(Point point);

    /** Largest distance of the outline from the item's position, m. */
    double reach();

    /** The engine's shape; empty if the engine refuses it. */
    Optional<Shape> shape();

    /** Whether it ends at its last corner instead of leading back to the first one. */
    default boolean isOpen() {
        return false;
    }

    /** Whether it is a landscape, which has no mass and cannot move. */
    default boolean isLandscape() {
        return false;
    }

    /** Position of that shape's centre of mass, m. */
    default Point centre() {
        return new Point(0, 0);
    }

    /** The form as a body's {@code shape} states it. */
    ObjectNode node();

    /** A body's {@code shape}. */
    static Form of(JsonNode shape) {
        return switch (shape.path("type").asString("")) {
            case "box" -> new Box(number(shape, "w"), number(shape, "h"), number(shape, "round"));
            case "circle" -> new Disc(number(shape, "r"));
            case "capsule" -> new Pill(number(shape, "length"), number(shape, "r"));
            case "compound" -> new Parts((ObjectNode) shape);
            case "chain" -> Landscape.of(shape);
            default -> Corners.of(shape.path("points"));
        };
    }

    private static double number(JsonNode shape, String name) {
        return Decimal.read(shape.path(name), 0);
    }
}
