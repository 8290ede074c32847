package tools.jackson.databind.node;

import tools.jackson.databind.JsonNode;

/** A value without other values in it; equal to others by its text. */
public abstract class ValueNode extends JsonNode {

    private final JsonNodeType kind;
    private final String text;

    ValueNode(JsonNodeType kind, String text) {
        this.kind = kind;
        this.text = text;
    }

    @Override
    public JsonNodeType getNodeType() {
        return kind;
    }

    /** The value as JSON. */
    @Override
    public String toString() {
        return text;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ValueNode value && value.kind == kind && value.text.equals(text);
    }

    @Override
    public int hashCode() {
        return text.hashCode();
    }
}
