package rigibo.lab.ablation;

import java.util.ArrayList;
import java.util.List;

/**
 * A horizontal axis.
 *
 * @param from value at its left end
 * @param to value at its right end
 * @param left px
 * @param right px
 */
record Axis(double from, double to, double left, double right) {

    private static final int MOST_TICKS = 8;

    /** Where a value is, px; what is beyond an end is at that end. */
    double at(double value) {
        double share = (value - from) / (to - from);
        return left + Math.max(0, Math.min(1, share)) * (right - left);
    }

    /** Round values, a few, within the axis. */
    List<Double> ticks() {
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

    /** Lines at the ticks over a height, their values below, and what they are. */
    void draw(Svg svg, double top, double bottom, String words) {
        for (double tick : ticks()) {
            svg.line(at(tick), top, at(tick), bottom, 1, Svg.GRID);
            svg.text(at(tick), bottom + 18, Svg.Anchor.MIDDLE, 13, Svg.DIM, Amount.percent(tick));
        }
        svg.line(at(0), top, at(0), bottom, 1, Svg.DIM);
        svg.text((left + right) / 2, bottom + 38, Svg.Anchor.MIDDLE, 14, Svg.INK, words);
    }
}
