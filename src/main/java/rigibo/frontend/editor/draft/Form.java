package rigibo.frontend.editor.draft;

import rigibo.backend.geometry.Shape;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * An outline relative to the point at which its item is placed; it may be one that cannot be
 * simulated.
 */
public sealed interface Form permits Box, Disc, Corners, Kept {

    /** Shapes of a level file that are shown, moved and turned, and not edited otherwise. */
    Set<String> BEYOND_TOOLS = Set.of("capsule", "compound", "chain");

    /** Corners in their order, m; none of a disc. */
    List<Point> corners();

    /** Whether a point lies within, m. */
    boolean contains(Point point);

    /** Largest distance of the outline from the item's position, m. */
    double reach();

    /** The engine's shape; empty if the engine refuses it. */
    Optional<Shape> shape();

    /** Position of that shape's centre of mass, m. */
    default Point centre() {
        return new Point(0, 0);
    }

    /** The form as a body's {@code shape} states it. */
    ObjectNode node();

    /** A body's {@code shape}. */
    static Form of(JsonNode shape) {
        if (shape instanceof ObjectNode stated && isBeyondTools(stated)) {
            return new Kept(stated);
        }
        return switch (shape.path("type").asString("")) {
            case "box" -> new Box(number(shape, "w"), number(shape, "h"));
            case "circle" -> new Disc(number(shape, "r"));
            default -> Corners.of(shape.path("points"));
        };
    }

    /** Whether the editor's tools would lose a part of the shape. */
    private static boolean isBeyondTools(ObjectNode shape) {
        String type = shape.path("type").asString("");
        return BEYOND_TOOLS.contains(type) || shape.has("round");
    }

    private static double number(JsonNode shape, String name) {
        return Decimal.read(shape.path(name), 0);
    }
}
