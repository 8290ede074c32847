package rigibo.lab.plot;

import java.util.ArrayList;
import java.util.List;

/**
 * A logarithmic scale.
 *
 * @param from value at the start, more than 0
 * @param to value at the end, more than {@code from}
 * @param start px
 * @param end px
 */
public record LogScale(double from, double to, double start, double end) implements Scale {

    /** The least distance of ticks, px: room for the label of a time. */
    private static final double LEAST_GAP = 46;

    /** The number of decades below which powers of ten alone would be too few ticks. */
    private static final double FEW_DECADES = 1.5;

    /** The relative rounding error of an end that is computed as a power of ten. */
    private static final double ROUNDING = 1e-9;

    @Override
    public double at(double value) {
        double share = Math.log(value / from) / Math.log(to / from);
        return start + Math.max(0, Math.min(1, share)) * (end - start);
    }

    @Override
    public List<Double> ticks() {
        double decades = Math.log10(to / from);
        double[] multiples = decades < FEW_DECADES ? new double[] {1, 2, 5} : new double[] {1};
        int every = (int) Math.max(1, Math.ceil(decades * LEAST_GAP / Math.abs(end - start)));
        List<Double> ticks = new ArrayList<>();
        int first = (int) Math.floor(Math.log10(from) + ROUNDING);
        for (int power = first; Math.pow(10, power) <= to * (1 + ROUNDING); power += every) {
            for (double multiple : multiples) {
                // The text is parsed to get the double nearest to the decimal number.
                double tick = Double.parseDouble((int) multiple + "e" + power);
                if (tick >= from * (1 - ROUNDING) && tick <= to * (1 + ROUNDING)) {
                    ticks.add(tick);
                }
            }
        }
        return ticks;
    }
}
