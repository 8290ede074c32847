package tools.jackson.databind.node;

import tools.jackson.databind.JsonNode;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;

/** A list. */
public final class ArrayNode extends JsonNode {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private final List<JsonNode> values = new ArrayList<>();

    ArrayNode() {}

    @Override
    public JsonNodeType getNodeType() {
        return JsonNodeType.ARRAY;
    }

    @Override
    public int size() {
        return values.size();
    }

    @Override
    public JsonNode get(int index) {
        return index >= 0 && index < values.size() ? values.get(index) : null;
    }

    @Override
    public Iterator<JsonNode> iterator() {
        return values.iterator();
    }

    public ArrayNode add(JsonNode value) {
        values.add(value);
        return this;
    }

    public ArrayNode add(String value) {
        return add(NODES.stringNode(value));
    }

    public ArrayNode add(double value) {
        return add(NODES.numberNode(value));
    }

    public ArrayNode add(int value) {
        return add(NODES.numberNode(value));
    }

    public ArrayNode set(int index, JsonNode value) {
        values.set(index, value);
        return this;
    }

    public JsonNode remove(int index) {
        return values.remove(index);
    }

    public ArrayNode addAll(Collection<? extends JsonNode> more) {
        values.addAll(more);
        return this;
    }

    public ArrayNode addAll(ArrayNode more) {
        return addAll(more.values);
    }

    public ObjectNode addObject() {
        ObjectNode added = new ObjectNode();
        add(added);
        return added;
    }

    public ArrayNode addArray() {
        ArrayNode added = new ArrayNode();
        add(added);
        return added;
    }

    /** A copy that shares no object or list with this one. */
    public ArrayNode deepCopy() {
        ArrayNode copy = new ArrayNode();
        values.forEach(value -> copy.add(ObjectNode.copyOf(value)));
        return copy;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ArrayNode list && list.values.equals(values);
    }

    @Override
    public int hashCode() {
        return values.hashCode();
    }

    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("[");
        values.forEach(value -> text.append(text.length() > 1 ? "," : "").append(value));
        return text.append(']').toString();
    }
}
