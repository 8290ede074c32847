package rigibo.frontend.editor.draft;

import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.level.Verb;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * A joint of a draft. Edits return a new one; its node never changes once it is part of one.
 *
 * @param pointer JSON pointer to the joint in the draft
 * @param node the joint as the level file states it
 */
public record JointEntry(String pointer, ObjectNode node) {

    /** JSON pointer of a draft's joints. */
    static final String JOINTS = "/joints";

    /** All joints of a draft whose type and points can be read, in its order. */
    public static List<JointEntry> all(Draft draft) {
        List<JointEntry> all = new ArrayList<>();
        for (int i = 0; i < draft.at(JOINTS).size(); i++) {
            of(draft, JOINTS + "/" + i).ifPresent(all::add);
        }
        return all;
    }

    /** The joint at a pointer, where there is one whose type and points can be read. */
    public static Optional<JointEntry> of(Draft draft, String pointer) {
        return pointer.startsWith(JOINTS + "/") && draft.at(pointer) instanceof ObjectNode node
                ? Optional.of(new JointEntry(pointer, node)).filter(JointEntry::isReadable)
                : Optional.empty();
    }

    /** The ids of all joints of a draft that have one. */
    static Set<String> ids(Draft draft) {
        Set<String> ids = new HashSet<>();
        draft.at(JOINTS).forEach(joint -> ids.add(joint.path("id").asString("")));
        ids.remove("");
        return ids;
    }

    private boolean isReadable() {
        return LevelJoint.of(node).isPresent()
                && anchors().stream()
                        .map(node::path)
                        .allMatch(
                                point ->
                                        point.isArray()
                                                && point.path(0).isNumber()
                                                && point.path(1).isNumber());
    }

    /** Its kind. */
    public LevelJoint.Type type() {
        String type = node.path("type").asString("");
        return LevelJoint.Type.valueOf(type.toUpperCase(Locale.ROOT));
    }

    /** Its id; empty if it has none. */
    public String id() {
        return node.path("id").asString("");
    }

    /** The effect of a click on it in play. */
    public Optional<Verb> verb() {
        return Verb.titled(node.path("click").asString(""));
    }

    /** The verbs of clicks that fit its kind, and its motor. */
    public List<Verb> fitting() {
        return Arrays.stream(Verb.values())
                .filter(verb -> verb.actsOn(type()))
                .filter(verb -> verb != Verb.SWITCH || node.has("motor"))
                .toList();
    }

    /** Returns this joint with a click acting on it, under an id of its own, or with none. */
    public JointEntry clicked(Draft draft, Optional<Verb> verb, boolean isOn) {
        ObjectNode changed = JsonNodeFactory.instance.objectNode();
        changed.setAll(node);
        changed.remove("click");
        changed.remove("on");
        if (verb.isPresent()) {
            changed.put("click", verb.get().title());
            if (!isOn) {
                changed.put("on", false);
            }
            if (id().isEmpty()) {
                changed.put("id", Ids.free(draft, node.path("type").asString("")));
            }
        }
        return new JointEntry(pointer, changed);
    }

    /** Name of its first end. */
    public String a() {
        return node.path("a").asString("");
    }

    /** Name of its second end, which a motor drives. */
    public String b() {
        return node.path("b").asString("");
    }

    /** The members that state its anchors: one for both ends, or one for each. */
    public List<String> anchors() {
        return type().hasTwoPoints() ? List.of("from", "to") : List.of("at");
    }

    /** Position of an anchor, m. */
    public Point point(String anchor) {
        JsonNode point = node.path(anchor);
        return new Point(Decimal.read(point.path(0), 0), Decimal.read(point.path(1), 0));
    }

    /** Distance between its anchors, m. */
    public double span() {
        Point last = point(anchors().get(anchors().size() - 1));
        return last.minus(point(anchors().get(0))).length();
    }

    /** Returns this joint with one of its anchors at another place, m. */
    public JointEntry at(String anchor, Point place) {
        return with(anchor, node(place));
    }

    /** A point as a level file states it. */
    static ArrayNode node(Point place) {
        return JsonNodeFactory.instance
                .arrayNode()
                .add(Decimal.of(place.x()))
                .add(Decimal.of(place.y()));
    }

    /** Returns this joint with one member changed. */
    public JointEntry with(String name, JsonNode value) {
        ObjectNode changed = JsonNodeFactory.instance.objectNode();
        changed.setAll(node);
        changed.set(name, value);
        return new JointEntry(pointer, changed);
    }

    /** Returns this joint with its two ends exchanged. */
    public JointEntry swapped() {
        JointEntry swapped = with("a", node.path("b")).with("b", node.path("a"));
        if (!type().hasTwoPoints()) {
            return swapped;
        }
        return swapped.at("from", point("to")).at("to", point("from"));
    }
}
