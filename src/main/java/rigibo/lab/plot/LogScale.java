package rigibo.lab.plot;

import java.util.ArrayList;
import java.util.List;

/**
 * Equal ratios are equally far apart.
 *
 * @param from value at the start, more than 0
 * @param to value at the end, more than {@code from}
 * @param start px
 * @param end px
 */
public record LogScale(double from, double to, double start, double end) implements Scale {

    /** Ticks are no nearer to each other than this, px: room for the label of a time. */
    private static final double LEAST_GAP = 46;

    /** Of less than so many decades, powers of ten alone would leave a reader without a tick. */
    private static final double FEW_DECADES = 1.5;

    /** Of an end that is computed as a power of ten, relative. */
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
                // Parsed, so that it is the double nearest to the decimal number.
                double tick = Double.parseDouble((int) multiple + "e" + power);
                if (tick >= from * (1 - ROUNDING) && tick <= to * (1 + ROUNDING)) {
                    ticks.add(tick);
                }
            }
        }
        return ticks;
    }
}
