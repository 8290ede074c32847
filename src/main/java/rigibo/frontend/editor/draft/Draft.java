package rigibo.frontend.editor.draft;

import tools.jackson.core.JsonPointer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A level while it is made; immutable. Edits share what they do not change with what they came
 * from, so that a long history costs little.
 */
public final class Draft {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;
    private static final String BODIES = "/bodies";

    private final ObjectNode root;

    private Draft(ObjectNode root) {
        this.root = root;
    }

    /**
     * The draft of a document. What a level must have and this one lacks is taken from {@link
     * NewLevel}.
     *
     * @throws IllegalArgumentException when it is no level at all, or one of a newer format, saying
     *     why
     */
    public static Draft of(JsonNode document) {
        return new Draft(Frame.of(document));
    }

    /** The document, to be read only. */
    public JsonNode document() {
        return root;
    }

    /** A value of the document; missing where there is none. */
    public JsonNode at(String pointer) {
        return root.at(pointer);
    }

    /** All that is placed, in the order in which it is drawn: what comes last lies on top. */
    public List<Item> items() {
        List<Item> items = new ArrayList<>();
        item("/platform").ifPresent(items::add);
        for (int i = 0; i < bodies().size(); i++) {
            item(BODIES + "/" + i).ifPresent(items::add);
        }
        item("/ball").ifPresent(items::add);
        return items;
    }

    private JsonNode bodies() {
        return at(BODIES);
    }

    /** What stands at a pointer, where that is something placed. */
    public Optional<Item> item(String pointer) {
        return at(pointer) instanceof ObjectNode node && node.has("x")
                ? Optional.of(new Item(pointer, node))
                : Optional.empty();
    }

    /** The same with an item changed. */
    public Draft with(Item item) {
        return with(item.pointer(), item.node());
    }

    /** The same with a value changed or added. */
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

    /** The same without a value. */
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

    /** The same with one more body, under an id of its own, at the end of the bodies. */
    public Draft plus(ObjectNode body) {
        ArrayNode more = NODES.arrayNode();
        bodies().forEach(more::add);
        ObjectNode named = NODES.objectNode();
        named.put("id", Ids.free(this, body.path("material").asString("body")));
        body.properties().forEach(member -> named.putIfAbsent(member.getKey(), member.getValue()));
        return with(BODIES, more.add(named));
    }

    /** The pointer of the last body. */
    public String lastBody() {
        return BODIES + "/" + (bodies().size() - 1);
    }

    /** The same without a body, and without the solutions that click it: they are none any more. */
    public Draft withoutBody(Item body) {
        return Clicks.forget(without(body.pointer()), body.id());
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
        return DraftText.of(root);
    }
}
