package rigibo.frontend.editor.draft;

import rigibo.frontend.puzzle.level.LevelJoint;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;

/** The joints of a draft, and their changes when their bodies change. */
public final class Joinery {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final String PLATFORM = "platform";
    private static final String BALL = "ball";

    /** Frequencies of new springs, Hz: that of a car's strut, and one that can be seen swinging. */
    private static final double STRUT_HERTZ = 4;

    private static final double STRUT_DAMPING = 0.7;
    private static final double SPRING_HERTZ = 1;
    private static final double SPRING_DAMPING = 0.1;

    private Joinery() {}

    /** The name by which joints refer to an item. */
    public static String name(Item item) {
        return switch (item.kind()) {
            case BODY -> item.id();
            case PLATFORM -> PLATFORM;
            case BALL -> item.isFurtherBall() ? ball(item) : BALL;
        };
    }

    private static String ball(Item further) {
        String number = further.pointer().substring(further.pointer().lastIndexOf('/') + 1);
        return BALL + (Integer.parseInt(number) + 2);
    }

    /** The item of an end; empty if there is none of that name. A body's id has precedence. */
    public static Optional<Item> item(Draft draft, String name) {
        return Optional.ofNullable(items(draft).get(name));
    }

    private static Map<String, Item> items(Draft draft) {
        Map<String, Item> items = new HashMap<>();
        for (Item item : draft.items()) {
            items.merge(
                    name(item), item, (one, other) -> one.kind() == Item.Kind.BODY ? one : other);
        }
        return items;
    }

    /** A joint of a kind as a level file states it, with numbers that have an effect. */
    public static ObjectNode node(LevelJoint.Type type, String a, String b, Point from, Point to) {
        ObjectNode node = NODES.objectNode();
        node.put("type", type.name().toLowerCase(Locale.ROOT)).put("a", a).put("b", b);
        if (type.hasTwoPoints()) {
            node.set("from", JointEntry.node(from));
            node.set("to", JointEntry.node(to));
        } else {
            node.set("at", JointEntry.node(to));
        }
        if (type == LevelJoint.Type.WHEEL) {
            node.set("spring", spring(STRUT_HERTZ, STRUT_DAMPING));
        }
        if (type == LevelJoint.Type.SPRING) {
            node.set("spring", spring(SPRING_HERTZ, SPRING_DAMPING));
        }
        return node;
    }

    /** A spring as a level file states it. */
    public static ObjectNode spring(double hertz, double damping) {
        return NODES.objectNode().put("hertz", hertz).put("damping", damping);
    }

    /** Returns the draft with one more joint, in a format with joints. */
    public static Draft plus(Draft draft, ObjectNode joint) {
        ArrayNode more = NODES.arrayNode();
        draft.at(JointEntry.JOINTS).forEach(more::add);
        return draft.inFormatTwo().with(JointEntry.JOINTS, more.add(joint));
    }

    /** The draft without a joint, and without the solutions that click it. */
    public static Draft without(Draft draft, JointEntry joint) {
        Draft rest = draft.without(joint.pointer());
        return Clicks.forgetJoints(
                rest.at(JointEntry.JOINTS).isEmpty() ? rest.without(JointEntry.JOINTS) : rest);
    }

    /** Returns the draft with an item renamed in all joints. */
    static Draft renamed(Draft draft, String before, String after) {
        return each(draft, node -> named(node, before, after));
    }

    private static JsonNode named(JsonNode joint, String before, String after) {
        if (!(joint instanceof ObjectNode stated) || !holds(joint, before)) {
            return joint;
        }
        ObjectNode named = NODES.objectNode();
        named.setAll(stated);
        for (String end : new String[] {"a", "b"}) {
            if (joint.path(end).asString("").equals(before)) {
                named.put(end, after);
            }
        }
        return named;
    }

    private static boolean holds(JsonNode joint, String name) {
        return joint.path("a").asString("").equals(name)
                || joint.path("b").asString("").equals(name);
    }

    /** Returns the draft without the joints of an item that was removed. */
    static Draft forget(Draft draft, Item gone) {
        String name = name(gone);
        Draft rest = kept(draft, joint -> !holds(joint, name));
        return gone.isFurtherBall() ? closedUp(rest, name) : rest;
    }

    /**
     * Returns the draft with the joints of one item given to another one, and without those that
     * joined the two.
     */
    static Draft handedOver(Draft draft, String from, String to) {
        return kept(
                renamed(draft, from, to),
                joint -> !joint.path("a").asString("").equals(joint.path("b").asString("")));
    }

    private static Draft kept(Draft draft, Predicate<JsonNode> stays) {
        ArrayNode kept = NODES.arrayNode();
        for (JsonNode joint : draft.at(JointEntry.JOINTS)) {
            if (stays.test(joint)) {
                kept.add(joint);
            }
        }
        return Clicks.forgetJoints(
                kept.isEmpty()
                        ? draft.without(JointEntry.JOINTS)
                        : draft.with(JointEntry.JOINTS, kept));
    }

    /** Renumbers the balls after one that was removed. */
    private static Draft closedUp(Draft draft, String gone) {
        Draft closed = draft;
        int number = Integer.parseInt(gone.substring(BALL.length()));
        for (int next = number + 1; next <= draft.at(Draft.MORE_BALLS).size() + 2; next++) {
            closed = renamed(closed, BALL + next, BALL + (next - 1));
        }
        return closed;
    }

    private static Draft each(Draft draft, UnaryOperator<JsonNode> edit) {
        if (draft.at(JointEntry.JOINTS).isEmpty()) {
            return draft;
        }
        ArrayNode edited = NODES.arrayNode();
        draft.at(JointEntry.JOINTS).forEach(joint -> edited.add(edit.apply(joint)));
        return draft.with(JointEntry.JOINTS, edited);
    }

    /**
     * Returns the draft that an edit made, with the anchors moved along with their items. An anchor
     * of two items follows the smaller one: the wheel, not the car.
     *
     * @param origin what a gesture began with, so that nothing is rounded at every move of a hand
     * @param present the draft before the edit
     * @param next what the edit made of it; joints that it changed itself stay as they are there
     */
    public static Draft followed(Draft origin, Draft present, Draft next) {
        JsonNode before = present.at(JointEntry.JOINTS);
        JsonNode after = next.at(JointEntry.JOINTS);
        if (after.isEmpty() || after != before) {
            return next;
        }
        Map<String, Item> from = items(origin);
        Map<String, Item> to = items(next);
        Draft followed = next;
        for (JointEntry joint : JointEntry.all(origin)) {
            JointEntry moved = moved(joint, from, to);
            if (!moved.node().equals(next.at(joint.pointer()))) {
                followed = followed.with(moved.pointer(), moved.node());
            }
        }
        return followed;
    }

    private static JointEntry moved(
            JointEntry joint, Map<String, Item> from, Map<String, Item> to) {
        JointEntry moved = joint;
        for (String anchor : joint.anchors()) {
            String end = carrier(joint, anchor, from);
            Item before = from.get(end);
            Item after = to.get(end);
            if (before != null && after != null && !isInPlace(before, after)) {
                moved = moved.at(anchor, after.toWorld(before.toOwn(joint.point(anchor))));
            }
        }
        return moved;
    }

    private static String carrier(JointEntry joint, String anchor, Map<String, Item> items) {
        if (joint.type().hasTwoPoints()) {
            return anchor.equals("from") ? joint.a() : joint.b();
        }
        Item a = items.get(joint.a());
        Item b = items.get(joint.b());
        boolean isOfA = a != null && b != null && a.form().reach() < b.form().reach();
        return isOfA ? joint.a() : joint.b();
    }

    private static boolean isInPlace(Item before, Item after) {
        return before.place().equals(after.place()) && before.degrees() == after.degrees();
    }

    /** The hook in whose middle an anchor lies, so that both are moved together. */
    public static Optional<Item> hook(Draft draft, JointEntry joint, String anchor) {
        return Optional.ofNullable(carrier(joint, anchor, items(draft)))
                .flatMap(name -> item(draft, name))
                .filter(Item::isFixed)
                .filter(item -> item.form() instanceof Disc && item.kind() == Item.Kind.BODY)
                .filter(item -> item.place().equals(joint.point(anchor)));
    }
}
