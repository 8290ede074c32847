package tools.jackson.databind.node;

/** A number. */
public final class NumericNode extends ValueNode {

    private final double value;
    private final boolean isInt;

    NumericNode(double value) {
        super(JsonNodeType.NUMBER, Double.toString(value));
        this.value = value;
        isInt = false;
    }

    NumericNode(long value) {
        super(JsonNodeType.NUMBER, Long.toString(value));
        this.value = value;
        isInt = value == (int) value;
    }

    @Override
    public boolean isInt() {
        return isInt;
    }

    @Override
    public double doubleValue() {
        return value;
    }
}
