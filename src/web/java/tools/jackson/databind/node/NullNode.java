package tools.jackson.databind.node;

/** The value null. */
public final class NullNode extends ValueNode {

    static final NullNode INSTANCE = new NullNode();

    private NullNode() {
        super(JsonNodeType.NULL, "null");
    }
}
