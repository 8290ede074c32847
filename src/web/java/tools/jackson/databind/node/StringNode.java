package tools.jackson.databind.node;

/** A text. */
public final class StringNode extends ValueNode {

    private final String value;

    StringNode(String value) {
        super(JsonNodeType.STRING, Quotes.of(value));
        this.value = value;
    }

    @Override
    public String stringValue() {
        return value;
    }
}
