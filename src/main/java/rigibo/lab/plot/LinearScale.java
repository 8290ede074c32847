package rigibo.lab.plot;

import java.util.ArrayList;
import java.util.List;

/**
 * A linear scale.
 *
 * @param from value at the start
 * @param to value at the end, more than {@code from}
 * @param start px
 * @param end px
 */
public record LinearScale(double from, double to, double start, double end) implements Scale {

    private static final int MOST_TICKS = 8;

    @Override
    public double at(double value) {
        double share = (value - from) / (to - from);
        return start + Math.max(0, Math.min(1, share)) * (end - start);
    }

    @Override
    public List<Double> ticks() {
        double step = Math.pow(10, Math.floor(Math.log10((to - from) / MOST_TICKS)));
        for (double factor : new double[] {2, 2.5, 2}) {
            if ((to - from) / step > MOST_TICKS) {
                step *= factor;
            }
        }
        List<Double> ticks = new ArrayList<>();
        for (double tick = Math.ceil(from / step) * step; tick <= to; tick += step) {
            ticks.add(tick);
        }
        return ticks;
    }
}
