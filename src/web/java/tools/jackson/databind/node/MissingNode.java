package tools.jackson.databind.node;

/** No value. */
public final class MissingNode extends ValueNode {

    public static final MissingNode INSTANCE = new MissingNode();

    private MissingNode() {
        super(JsonNodeType.MISSING, "");
    }
}
