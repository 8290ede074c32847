package rigibo.lab.ablation;

import rigibo.lab.ablation.Findings.Ablation;
import rigibo.lab.child.Interval;
import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Picture;
import rigibo.lab.report.Amount;

import java.util.List;

/** The ratio of each scene with its interval, against the band within which it counts as equal. */
final class RatioPanel {

    private static final double ROW = 30;

    /** The narrowest axis, % to each side: the band and a margin. */
    private static final double LEAST_REACH = 2;

    /** The widest axis, on which the band is still visible after a run on a busy machine. */
    private static final double MOST_REACH = 25;

    private final List<Ablation> scenes;
    private final Axis axis;

    RatioPanel(List<Ablation> scenes) {
        this.scenes = scenes;
        double reach =
                scenes.stream()
                        .map(one -> one.pairs().ratio())
                        .mapToDouble(one -> Math.max(-percent(one.low()), percent(one.high())))
                        .max()
                        .orElse(0);
        double end = Math.ceil(Math.max(LEAST_REACH, Math.min(MOST_REACH, reach)));
        axis = new Axis(-end, end, 130, 740);
    }

    private static double percent(double ratio) {
        return 100 * (ratio - 1);
    }

    /** Draws it below a height and returns its lower edge. */
    double draw(Picture picture, double top) {
        double bottom = top + ROW * scenes.size();
        double band = 100 * Findings.TOLERANCE;
        picture.box(axis.at(-band), axis.at(band), top, bottom - top, Palette.BAND);
        axis.draw(picture, top, bottom, "time per step with the classes, % more than without them");
        for (int i = 0; i < scenes.size(); i++) {
            draw(picture, scenes.get(i), top + (i + 0.5) * ROW);
        }
        return bottom + 40;
    }

    private void draw(Picture picture, Ablation scene, double y) {
        Interval ratio = scene.pairs().ratio();
        picture.text(axis.left() - 12, y + 5, Anchor.END, 14, Palette.INK, scene.scene());
        double low = axis.at(percent(ratio.low()));
        picture.line(low, y, axis.at(percent(ratio.high())), y, 3, Palette.BLUE);
        picture.dot(axis.at(percent(ratio.median())), y, 5, Palette.BLUE);
        String words =
                Amount.digits(percent(ratio.median()))
                        + " % ("
                        + Amount.digits(percent(ratio.low()))
                        + " to "
                        + Amount.digits(percent(ratio.high()))
                        + ")";
        picture.text(axis.right() + 20, y + 5, Anchor.START, 14, Palette.INK, words);
    }
}
