package tools.jackson.databind.node;

/** Makes values. */
public final class JsonNodeFactory {

    public static final JsonNodeFactory instance = new JsonNodeFactory();

    private JsonNodeFactory() {}

    public ObjectNode objectNode() {
        return new ObjectNode();
    }

    public ArrayNode arrayNode() {
        return new ArrayNode();
    }

    public StringNode stringNode(String value) {
        return new StringNode(value);
    }

    public BooleanNode booleanNode(boolean value) {
        return new BooleanNode(value);
    }

    public NullNode nullNode() {
        return NullNode.INSTANCE;
    }

    public NumericNode numberNode(double value) {
        return new NumericNode(value);
    }

    public NumericNode numberNode(int value) {
        return new NumericNode((long) value);
    }

    public NumericNode numberNode(long value) {
        return new NumericNode(value);
    }
}
