package rigibo.frontend.editor.draft;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;

/** Makes one body out of several, and several out of one. */
public final class Gluing {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    /** Most parts of a compound in a level file. */
    private static final int MOST = 16;

    private static final String ANGLE = "angle";
    private static final String PARTS = "parts";
    private static final String SHAPE = "shape";

    private Gluing() {}

    /** Whether two items can be made one: two bodies of no more parts than a file may have. */
    public static boolean canGlue(Item one, Item other) {
        return canBePart(one)
                && canBePart(other)
                && !one.pointer().equals(other.pointer())
                && parts(one).size() + parts(other).size() <= MOST;
    }

    private static boolean canBePart(Item item) {
        return item.kind() == Item.Kind.BODY && !item.form().isLandscape();
    }

    /**
     * Returns the draft with a body's parts given to another one, which keeps all else that it is.
     * Joints of the body that is gone go on to hold the other one; what joined the two is gone.
     */
    public static Draft glued(Draft draft, Item keeper, Item given) {
        ArrayNode parts = NODES.arrayNode();
        parts(keeper).forEach(parts::add);
        for (ObjectNode part : parts(given)) {
            Point middle = given.toWorld(place(part));
            parts.add(
                    placed(
                            part,
                            keeper.toOwn(middle),
                            degrees(part) + given.degrees() - keeper.degrees()));
        }
        Draft whole = draft.with(keeper.with(SHAPE, compound(parts)));
        return Clicks.forget(
                Joinery.handedOver(whole, given.id(), keeper.id()).without(given.pointer()),
                given.id());
    }

    /** Returns the draft with each part of a body as a body of its own; the first keeps its id. */
    public static Draft apart(Draft draft, Item body) {
        List<ObjectNode> parts = parts(body);
        Draft taken = draft.with(alone(body, parts.get(0)));
        for (ObjectNode part : parts.subList(1, parts.size())) {
            ObjectNode copy = alone(body, part).node().deepCopy();
            copy.remove("id");
            taken = taken.plus(copy);
        }
        return taken;
    }

    private static Item alone(Item body, ObjectNode part) {
        return body.with(SHAPE, part.path(SHAPE))
                .at(body.toWorld(place(part)))
                .turnedTo(body.degrees() + degrees(part));
    }

    /** The parts of a body; a body in one piece is a part by itself. */
    private static List<ObjectNode> parts(Item body) {
        JsonNode shape = body.node().path(SHAPE);
        List<ObjectNode> parts = new ArrayList<>();
        for (JsonNode part : shape.path(PARTS)) {
            if (part instanceof ObjectNode stated) {
                parts.add(stated);
            }
        }
        if (parts.isEmpty()) {
            parts.add(NODES.objectNode().set(SHAPE, shape));
        }
        return parts;
    }

    private static Point place(JsonNode part) {
        return new Point(Decimal.read(part.path("x"), 0), Decimal.read(part.path("y"), 0));
    }

    private static double degrees(JsonNode part) {
        return Decimal.read(part.path(ANGLE), 0);
    }

    private static ObjectNode placed(ObjectNode part, Point place, double degrees) {
        ObjectNode placed = NODES.objectNode();
        placed.setAll(part);
        placed.set("x", Decimal.of(place.x()));
        placed.set("y", Decimal.of(place.y()));
        placed.set(ANGLE, Decimal.of(Math.IEEEremainder(degrees, 360)));
        return placed;
    }

    private static ObjectNode compound(ArrayNode parts) {
        return NODES.objectNode().put("type", "compound").set(PARTS, parts);
    }

    /** A compound of convex outlines that share a frame. */
    static ObjectNode compound(List<Corners> outlines) {
        ArrayNode parts = NODES.arrayNode();
        outlines.forEach(outline -> parts.addObject().set(SHAPE, outline.node()));
        return compound(parts);
    }
}
