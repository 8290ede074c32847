package tools.jackson.databind.node;

import tools.jackson.databind.JsonNode;

import java.util.Collection;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/** Values by names, in the order of insertion. */
public final class ObjectNode extends JsonNode {

    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private final Map<String, JsonNode> values = new LinkedHashMap<>();

    ObjectNode() {}

    @Override
    public JsonNodeType getNodeType() {
        return JsonNodeType.OBJECT;
    }

    @Override
    public int size() {
        return values.size();
    }

    @Override
    public JsonNode get(String name) {
        return values.get(name);
    }

    @Override
    public Set<Map.Entry<String, JsonNode>> properties() {
        return values.entrySet();
    }

    @Override
    public Collection<String> propertyNames() {
        return values.keySet();
    }

    @Override
    public Iterator<JsonNode> iterator() {
        return values.values().iterator();
    }

    public ObjectNode set(String name, JsonNode value) {
        values.put(name, value);
        return this;
    }

    public JsonNode putIfAbsent(String name, JsonNode value) {
        return values.putIfAbsent(name, value);
    }

    public JsonNode remove(String name) {
        return values.remove(name);
    }

    public ObjectNode remove(Collection<String> names) {
        values.keySet().removeAll(names);
        return this;
    }

    public ObjectNode setAll(ObjectNode others) {
        values.putAll(others.values);
        return this;
    }

    public ObjectNode put(String name, String value) {
        return set(name, NODES.stringNode(value));
    }

    public ObjectNode put(String name, boolean value) {
        return set(name, NODES.booleanNode(value));
    }

    public ObjectNode put(String name, double value) {
        return set(name, NODES.numberNode(value));
    }

    public ObjectNode put(String name, int value) {
        return set(name, NODES.numberNode(value));
    }

    public ObjectNode put(String name, long value) {
        return set(name, NODES.numberNode(value));
    }

    public ObjectNode putObject(String name) {
        ObjectNode put = new ObjectNode();
        set(name, put);
        return put;
    }

    public ArrayNode putArray(String name) {
        ArrayNode put = new ArrayNode();
        set(name, put);
        return put;
    }

    /** The list of a name; makes one if there is none. */
    public ArrayNode withArray(String name) {
        return has(name) ? (ArrayNode) get(name) : putArray(name);
    }

    /** A copy that shares no object or list with this one. */
    public ObjectNode deepCopy() {
        ObjectNode copy = new ObjectNode();
        values.forEach((name, value) -> copy.set(name, copyOf(value)));
        return copy;
    }

    static JsonNode copyOf(JsonNode value) {
        if (value instanceof ObjectNode object) {
            return object.deepCopy();
        }
        return value instanceof ArrayNode list ? list.deepCopy() : value;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ObjectNode object && object.values.equals(values);
    }

    @Override
    public int hashCode() {
        return values.hashCode();
    }

    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("{");
        values.forEach(
                (name, value) ->
                        text.append(text.length() > 1 ? "," : "")
                                .append(Quotes.of(name))
                                .append(':')
                                .append(value));
        return text.append('}').toString();
    }
}
