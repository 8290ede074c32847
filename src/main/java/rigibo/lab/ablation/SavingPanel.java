package rigibo.lab.ablation;

import rigibo.lab.ablation.Findings.Ablation;
import rigibo.lab.ablation.Findings.Saving;
import rigibo.lab.child.Interval;
import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Picture;
import rigibo.lab.report.Amount;

/** A bar for each effect of each scene: the share of a step that is saved without it. */
final class SavingPanel {

    private static final double ROW = 24;
    private static final double HEAD = 26;

    /** The left end of the axis, %: without a brake a scene may cost more than before. */
    private static final double LEAST = -100;

    private final Findings findings;
    private final Axis axis;

    SavingPanel(Findings findings) {
        this.findings = findings;
        double least =
                findings.savings().stream()
                        .mapToDouble(saving -> saving.percent().low())
                        .min()
                        .orElse(0);
        double from = Math.max(LEAST, 10 * Math.floor(Math.min(0, least) / 10));
        axis = new Axis(from, 100, 330, 790);
    }

    /** Draws it below a height and returns its lower edge. */
    double draw(Picture picture, double top) {
        double bottom = top + HEAD * findings.ablations().size() + ROW * findings.savings().size();
        axis.draw(picture, top, bottom, "saved per step, % of the whole scene's step");
        double y = top;
        for (Ablation scene : findings.ablations()) {
            picture.text(40, y + 18, Anchor.START, 15, Palette.INK, scene.scene());
            y += HEAD;
            for (Saving saving : findings.savingsOf(scene.scene()).toList()) {
                draw(picture, saving, y + ROW / 2);
                y += ROW;
            }
        }
        return bottom + 40;
    }

    private void draw(Picture picture, Saving saving, double y) {
        Interval percent = saving.percent();
        picture.text(axis.left() - 12, y + 5, Anchor.END, 14, Palette.INK, words(saving));
        picture.box(axis.at(0), axis.at(percent.median()), y - 7, 14, Palette.BLUE);
        picture.line(axis.at(percent.low()), y, axis.at(percent.high()), y, 2, Palette.VERMILLION);
        String value =
                Amount.percent(percent.median())
                        + " %, "
                        + Amount.time(saving.pairs().difference().median());
        picture.text(axis.right() + 16, y + 5, Anchor.START, 14, Palette.INK, value);
    }

    private static String words(Saving saving) {
        int companions = saving.companions().size();
        String more =
                switch (companions) {
                    case 0 -> "";
                    case 1 -> " and " + saving.companions().get(0);
                    default -> " and " + companions + " that need it";
                };
        return "without " + saving.effect() + more;
    }
}
