package tools.jackson.databind;

import tools.jackson.core.JsonPointer;
import tools.jackson.databind.exc.JsonNodeException;
import tools.jackson.databind.node.JsonNodeType;
import tools.jackson.databind.node.MissingNode;

import java.util.Collection;
import java.util.Collections;
import java.util.Iterator;
import java.util.Map;
import java.util.Set;

/** A value of a tree; asked for another kind than its own, it acts like a missing one. */
public abstract class JsonNode implements Iterable<JsonNode> {

    public abstract JsonNodeType getNodeType();

    public boolean isObject() {
        return getNodeType() == JsonNodeType.OBJECT;
    }

    public boolean isArray() {
        return getNodeType() == JsonNodeType.ARRAY;
    }

    public boolean isString() {
        return getNodeType() == JsonNodeType.STRING;
    }

    public boolean isNumber() {
        return getNodeType() == JsonNodeType.NUMBER;
    }

    public boolean isBoolean() {
        return getNodeType() == JsonNodeType.BOOLEAN;
    }

    public boolean isMissingNode() {
        return getNodeType() == JsonNodeType.MISSING;
    }

    /** Whether it is a number that was written as an integer. */
    public boolean isInt() {
        return false;
    }

    public int size() {
        return 0;
    }

    public boolean isEmpty() {
        return size() == 0;
    }

    public JsonNode get(String name) {
        return null;
    }

    public JsonNode get(int index) {
        return null;
    }

    public boolean has(String name) {
        return get(name) != null;
    }

    public JsonNode path(String name) {
        JsonNode found = get(name);
        return found == null ? MissingNode.INSTANCE : found;
    }

    public JsonNode path(int index) {
        JsonNode found = get(index);
        return found == null ? MissingNode.INSTANCE : found;
    }

    /** The value at a pointer as RFC 6901 writes it. */
    public JsonNode at(String pointer) {
        return at(JsonPointer.compile(pointer));
    }

    public JsonNode at(JsonPointer pointer) {
        JsonNode found = this;
        for (JsonPointer rest = pointer; !rest.matches(); rest = rest.tail()) {
            found =
                    found.isArray()
                            ? found.path(rest.getMatchingIndex())
                            : found.path(rest.getMatchingProperty());
        }
        return found;
    }

    public Set<Map.Entry<String, JsonNode>> properties() {
        return Collections.emptySet();
    }

    public Collection<String> propertyNames() {
        return Collections.emptySet();
    }

    @Override
    public Iterator<JsonNode> iterator() {
        return Collections.emptyIterator();
    }

    public String stringValue() {
        throw refused("text");
    }

    public double doubleValue() {
        throw refused("number");
    }

    public int intValue() {
        return (int) doubleValue();
    }

    public boolean booleanValue() {
        throw refused("truth value");
    }

    public String asString() {
        return switch (getNodeType()) {
            case STRING -> stringValue();
            case NUMBER, BOOLEAN -> toString();
            case NULL -> "";
            case ARRAY, BINARY, MISSING, OBJECT, POJO -> throw refused("text");
        };
    }

    public String asString(String otherwise) {
        return isString() || isNumber() || isBoolean() ? asString() : otherwise;
    }

    public double asDouble() {
        return doubleValue();
    }

    public double asDouble(double otherwise) {
        return isNumber() ? doubleValue() : otherwise;
    }

    public int asInt() {
        return intValue();
    }

    public int asInt(int otherwise) {
        return isNumber() ? intValue() : otherwise;
    }

    public long asLong(long otherwise) {
        return isNumber() ? (long) doubleValue() : otherwise;
    }

    public boolean asBoolean(boolean otherwise) {
        return isBoolean() ? booleanValue() : otherwise;
    }

    private JsonNodeException refused(String wanted) {
        return new JsonNodeException("is no " + wanted + ": " + this);
    }
}
