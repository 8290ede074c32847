package rigibo.frontend.editor.draft;

import rigibo.frontend.puzzle.level.LevelJoint;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.List;
import java.util.Optional;

/**
 * Turns poses in which a draft came to rest into its start. A joint is what its file states at the
 * start, so that numbers which count from there are stated anew.
 *
 * @param origin the draft before anything moved
 * @param rested the draft with the new poses, its anchors moved along
 */
public record Settled(Draft origin, Draft rested) {

    /** Members of a motion, which is over. */
    private static final List<String> MOTION = List.of("vx", "vy", "spin");

    /**
     * Returns a draft as far as it matters to what moves by itself, so that it can be played before
     * anything can be clicked.
     */
    public static Draft loose(Draft draft) {
        Draft loose = draft.without("/solutions").without("/star");
        Optional<Item> first = loose.item("/bodies/0");
        boolean hasClicks = loose.items().stream().anyMatch(Settled::isClickable);
        return hasClicks || first.isEmpty()
                ? loose
                : loose.with(
                        first.get().with("deletable", JsonNodeFactory.instance.booleanNode(true)));
    }

    private static boolean isClickable(Item item) {
        return item.isDeletable() || item.verb().isPresent();
    }

    /** Returns an item at a pose, m and degrees: that of its body's centre of mass. */
    public static Item posed(Item item, Point centre, double degrees) {
        if (item.kind() == Item.Kind.BALL) {
            return item.at(centre);
        }
        Item placed = item.at(centre.minus(item.form().centre().turned(degrees)));
        boolean isTurned = Decimal.rounded(degrees) != Decimal.rounded(item.degrees());
        return isTurned ? placed.turnedTo(degrees) : placed;
    }

    /** The draft that begins at rest. */
    public Draft start() {
        Draft start = rested;
        for (Item item : rested.items()) {
            start = start.with(still(item));
        }
        for (JointEntry joint : JointEntry.all(rested)) {
            Optional<JointEntry> before = JointEntry.of(origin, joint.pointer());
            if (before.isPresent()) {
                start = start.with(joint.pointer(), restated(before.get(), joint).node());
            }
        }
        return start;
    }

    private static Item still(Item item) {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.setAll(item.node());
        node.remove(MOTION);
        return new Item(item.pointer(), node);
    }

    private JointEntry restated(JointEntry before, JointEntry joint) {
        return switch (joint.type()) {
            case ROPE -> tied(before, joint);
            case SPRING -> before.node().has("length") ? joint : ofLength(joint, before.span());
            case HINGE -> limited(joint, turned(joint.b()) - turned(joint.a()));
            case WHEEL, SLIDE -> onItsRail(before, joint);
            case WELD, ROD -> joint;
        };
    }

    /** A rope is as long as it was, and reaches from end to end. */
    private static JointEntry tied(JointEntry before, JointEntry joint) {
        double length = Decimal.read(before.node().path("length"), before.span());
        return ofLength(joint, Math.max(length, joint.span()));
    }

    private static JointEntry ofLength(JointEntry joint, double metres) {
        boolean isPlain = Decimal.rounded(metres) == Decimal.rounded(joint.span());
        return isPlain && !joint.node().has("length")
                ? joint
                : joint.with("length", Decimal.of(metres));
    }

    /** By how much an item was turned, degrees, half a turn either way. */
    private double turned(String name) {
        double now = Joinery.item(rested, name).map(Item::degrees).orElse(0.0);
        double then = Joinery.item(origin, name).map(Item::degrees).orElse(0.0);
        return Math.IEEEremainder(now - then, 360);
    }

    /** Limits count from the start, which has moved on by so much. */
    private static JointEntry limited(JointEntry joint, double moved) {
        JsonNode limits = joint.node().path("limits");
        if (!limits.isArray()) {
            return joint;
        }
        double lower = Decimal.read(limits.path(0), 0) - moved;
        double upper = Decimal.read(limits.path(1), 0) - moved;
        return joint.with(
                "limits",
                JsonNodeFactory.instance
                        .arrayNode()
                        .add(Decimal.of(Math.min(0, lower)))
                        .add(Decimal.of(Math.max(0, upper))));
    }

    /** The rail turns with its first body; what runs on it has run some way. */
    private JointEntry onItsRail(JointEntry before, JointEntry joint) {
        double usual = joint.type() == LevelJoint.Type.WHEEL ? 90 : 0;
        double axis = Decimal.read(before.node().path("axis"), usual) + turned(joint.a());
        Point way = carried(before, joint.b()).minus(carried(before, joint.a()));
        double along = way.turned(-axis).x();
        JointEntry turned = turned(joint.a()) == 0 ? joint : joint.with("axis", Decimal.of(axis));
        return limited(turned, along);
    }

    /** Where an item has taken the point at which it was joined. */
    private Point carried(JointEntry before, String name) {
        Point at = before.point("at");
        Optional<Item> then = Joinery.item(origin, name);
        Optional<Item> now = Joinery.item(rested, name);
        return then.isPresent() && now.isPresent() ? now.get().toWorld(then.get().toOwn(at)) : at;
    }
}
