package tools.jackson.databind.node;

/** True or false. */
public final class BooleanNode extends ValueNode {

    private final boolean value;

    BooleanNode(boolean value) {
        super(JsonNodeType.BOOLEAN, Boolean.toString(value));
        this.value = value;
    }

    @Override
    public boolean booleanValue() {
        return value;
    }
}
