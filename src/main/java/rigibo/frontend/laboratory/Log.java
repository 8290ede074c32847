package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Scene;

import java.util.Locale;

/** The measurements of each step since the start, up to ten minutes. */
final class Log {

    /** Steps that are kept, the latest ones: 10 min. */
    private static final int KEPT = 36_000;

    /** Values of a step: of each quantity one for the left world, and one for the right one. */
    private static final int VALUES = 2 * Quantity.values().length;

    private double[] values = new double[64 * VALUES];
    private int steps;

    /** Takes what a step of both worlds led to. */
    void add(Half left, Half right, double distance) {
        int at = steps % KEPT * VALUES;
        if (at == values.length) {
            double[] more = new double[Math.min(2 * values.length, KEPT * VALUES)];
            System.arraycopy(values, 0, more, 0, values.length);
            values = more;
        }
        for (Quantity quantity : Quantity.values()) {
            boolean isShared = quantity.isShared();
            values[at++] = isShared ? distance : quantity.of(left);
            values[at++] = isShared ? distance : quantity.of(right);
        }
        steps++;
    }

    /** How many steps are kept. */
    int count() {
        return Math.min(steps, KEPT);
    }

    /** The side of a value. */
    enum Side {
        LEFT,
        RIGHT
    }

    /** A value of a step, 0 the oldest that is kept. */
    double value(Quantity quantity, Side side, int step) {
        int at = (steps - count() + step) % KEPT;
        return values[at * VALUES + 2 * quantity.ordinal() + side.ordinal()];
    }

    /**
     * The whole log as a table: a line of description, a line of names, and a line for each step,
     * with commas as separators and decimal points.
     */
    String table(String about) {
        StringBuilder table = new StringBuilder("# ").append(about).append("\ntime_s");
        for (Quantity quantity : Quantity.values()) {
            if (quantity.isShared()) {
                table.append(',').append(quantity.column);
            } else {
                table.append(",left_").append(quantity.column);
                table.append(",right_").append(quantity.column);
            }
        }
        table.append('\n');
        int first = steps - count();
        for (int i = 0; i < count(); i++) {
            double seconds = (first + i + 1) * Scene.STEP;
            table.append(String.format(Locale.ROOT, "%.4f", seconds));
            for (Quantity quantity : Quantity.values()) {
                table.append(',').append(value(quantity, Side.LEFT, i));
                if (!quantity.isShared()) {
                    table.append(',').append(value(quantity, Side.RIGHT, i));
                }
            }
            table.append('\n');
        }
        return table.toString();
    }
}
