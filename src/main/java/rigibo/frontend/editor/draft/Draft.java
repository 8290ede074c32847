package rigibo.frontend.editor.draft;

import rigibo.frontend.puzzle.level.LevelText;

import tools.jackson.core.JsonPointer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A level in the making; immutable. A new version shares everything unchanged with the one it came
 * from, so that a long history costs little.
 */
public final class Draft {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final String BODIES = "/bodies";
    static final String MORE_BALLS = "/moreBalls";

    /** The first format with joints. */
    private static final int FORMAT = 2;

    private final ObjectNode root;

    private Draft(ObjectNode root) {
        this.root = root;
    }

    /**
     * Makes the draft of a document. Required members that are missing are taken from {@link
     * NewLevel}.
     *
     * @throws IllegalArgumentException when it is no level at all, or one of a newer format, saying
     *     why
     */
    public static Draft of(JsonNode document) {
        return new Draft(Frame.of(document));
    }

    /** Whether a document has a newer format, so that its content cannot be judged. */
    public static boolean isNewer(JsonNode document) {
        return Frame.isNewer(document);
    }

    /** The document; it must not be changed. */
    public JsonNode document() {
        return root;
    }

    /** A value of the document, or a missing node if there is none. */
    public JsonNode at(String pointer) {
        return root.at(pointer);
    }

    /** All items in the order in which they are drawn; the last one lies on top. */
    public List<Item> items() {
        List<Item> items = new ArrayList<>();
        item("/platform").ifPresent(items::add);
        addAll(items, BODIES);
        addAll(items, MORE_BALLS);
        item("/ball").ifPresent(items::add);
        return items;
    }

    private void addAll(List<Item> items, String list) {
        for (int i = 0; i < at(list).size(); i++) {
            item(list + "/" + i).ifPresent(items::add);
        }
    }

    /** The item at a pointer, if there is one. */
    public Optional<Item> item(String pointer) {
        return at(pointer) instanceof ObjectNode node && node.has("x")
                ? Optional.of(new Item(pointer, node))
                : Optional.empty();
    }

    /** Returns this draft in the first format with joints, paths, and clicks besides deleting. */
    public Draft inFormatTwo() {
        return with("/format", NODES.numberNode(FORMAT));
    }

    /** Returns this draft with an item replaced. */
    public Draft with(Item item) {
        return with(item.pointer(), item.node());
    }

    /** Returns this draft with a value changed or added. */
    public Draft with(String pointer, JsonNode value) {
        return new Draft((ObjectNode) replaced(root, JsonPointer.compile(pointer), value));
    }

    private static JsonNode replaced(JsonNode node, JsonPointer at, JsonNode value) {
        if (at.matches()) {
            return value;
        }
        if (node instanceof ArrayNode list) {
            ArrayNode copy = NODES.arrayNode().addAll(list);
            int index = at.getMatchingIndex();
            copy.set(index, replaced(list.path(index), at.tail(), value));
            return copy;
        }
        ObjectNode copy = NODES.objectNode();
        if (node instanceof ObjectNode object) {
            copy.setAll(object);
        }
        String name = at.getMatchingProperty();
        copy.set(name, replaced(copy.path(name), at.tail(), value));
        return copy;
    }

    /** Returns this draft without a value. */
    public Draft without(String pointer) {
        JsonPointer at = JsonPointer.compile(pointer);
        JsonNode around = root.at(at.head());
        if (around instanceof ArrayNode list) {
            ArrayNode rest = NODES.arrayNode().addAll(list);
            rest.remove(at.last().getMatchingIndex());
            return with(at.head().toString(), rest);
        }
        ObjectNode rest = NODES.objectNode();
        if (around instanceof ObjectNode object) {
            rest.setAll(object);
        }
        rest.remove(at.last().getMatchingProperty());
        return with(at.head().toString(), rest);
    }

    /** Returns this draft with a further body, under an id of its own, after the others. */
    public Draft plus(ObjectNode body) {
        return plus(body, body.path("material").asString("body"));
    }

    /** Returns this draft with a further body, named by a word and the next free number. */
    public Draft plus(ObjectNode body, String word) {
        ObjectNode named = NODES.objectNode();
        named.put("id", Ids.free(this, word));
        body.properties().forEach(member -> named.putIfAbsent(member.getKey(), member.getValue()));
        return plus(BODIES, named);
    }

    /** Returns this draft with a further ball, like the first one. */
    public Draft plusBall(Point place) {
        Item first = new Item("/ball", (ObjectNode) at("/ball"));
        return plus(MORE_BALLS, first.at(place).node());
    }

    private Draft plus(String list, ObjectNode last) {
        ArrayNode more = NODES.arrayNode();
        at(list).forEach(more::add);
        return with(list, more.add(last));
    }

    /** The last body. */
    public Item lastBody() {
        return last(BODIES);
    }

    /** The last of the further balls. */
    public Item lastBall() {
        return last(MORE_BALLS);
    }

    private Item last(String list) {
        return item(list + "/" + (at(list).size() - 1)).orElseThrow();
    }

    /**
     * Returns this draft without an item, its joints, and the solutions that click it, which are no
     * longer valid.
     */
    public Draft without(Item item) {
        Draft rest = without(item.pointer());
        boolean wasLastBall = item.isFurtherBall() && rest.at(MORE_BALLS).isEmpty();
        Draft parted = Joinery.forget(rest, item);
        return wasLastBall ? parted.without(MORE_BALLS) : Clicks.forget(parted, item.id());
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Draft draft && draft.root.equals(root);
    }

    @Override
    public int hashCode() {
        return root.hashCode();
    }

    @Override
    public String toString() {
        return LevelText.of(root);
    }
}
