package rigibo.lab.ablation;

import rigibo.lab.ablation.Findings.UseCost;
import rigibo.lab.child.Interval;
import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Picture;
import rigibo.lab.report.Amount;

import java.util.List;

/** A small plot per effect: users to the right, cost upwards, each on a scale of its own. */
final class UsePanel {

    private static final int COLUMNS = 4;
    private static final double LEFT = 40;
    private static final double WIDTH = 230;
    private static final double HEIGHT = 170;

    /** The size of the plot within its cell. */
    private static final double PLOT_WIDTH = 190;

    private static final double PLOT_TOP = 46;
    private static final double PLOT_HEIGHT = 80;

    private final Findings findings;

    UsePanel(Findings findings) {
        this.findings = findings;
    }

    /** Draws it below a height and returns its lower edge. */
    double draw(Picture picture, double top) {
        List<String> effects = findings.effects();
        for (int i = 0; i < effects.size(); i++) {
            double x = LEFT + WIDTH * (i % COLUMNS);
            double y = top + HEIGHT * (i / COLUMNS);
            drawCell(picture, findings.usesOf(effects.get(i)), x, y);
        }
        int rows = (effects.size() + COLUMNS - 1) / COLUMNS;
        double bottom = top + HEIGHT * rows;
        String words =
                "bodies that use the effect; upwards: time per step more than undeclared."
                        + " Dashed: proportional to the users";
        picture.text(EffectsFigure.WIDTH / 2, bottom, Anchor.MIDDLE, 14, Palette.INK, words);
        return bottom;
    }

    private void drawCell(Picture picture, List<UseCost> uses, double x, double y) {
        UseCost none = uses.get(0);
        UseCost all = uses.get(uses.size() - 1);
        picture.text(
                x,
                y + 12,
                Anchor.START,
                14,
                Palette.INK,
                none.effect() + " (" + none.scene() + ")");
        String words = "none " + words(none) + ", all " + words(all);
        picture.text(x, y + 30, Anchor.START, 13, Palette.BLUE, words);
        Plot plot = new Plot(picture, x, y + PLOT_TOP, uses);
        plot.draw(all.users());
        String[] ends = {"0", "" + all.users()};
        picture.text(x, y + PLOT_TOP + PLOT_HEIGHT + 18, Anchor.START, 12, Palette.DIM, ends[0]);
        picture.text(
                x + PLOT_WIDTH,
                y + PLOT_TOP + PLOT_HEIGHT + 18,
                Anchor.END,
                12,
                Palette.DIM,
                ends[1]);
    }

    private static String words(UseCost use) {
        return Amount.signedTime(use.pairs().difference().median());
    }

    /** The plot of one effect, which reaches from the least cost or 0 to the greatest or 0. */
    private static final class Plot {

        private final Picture picture;
        private final double x;
        private final double y;
        private final List<UseCost> uses;
        private double least;
        private double most;

        Plot(Picture picture, double x, double y, List<UseCost> uses) {
            this.picture = picture;
            this.x = x;
            this.y = y;
            this.uses = uses;
            for (UseCost use : uses) {
                least = Math.min(least, use.pairs().difference().low());
                most = Math.max(most, use.pairs().difference().high());
            }
        }

        private double across(UseCost use, int all) {
            return x + PLOT_WIDTH * use.users() / all;
        }

        private double up(double nanos) {
            return y + PLOT_HEIGHT * (most - nanos) / (most - least);
        }

        void draw(int all) {
            picture.line(x, up(0), x + PLOT_WIDTH, up(0), 1, Palette.DIM);
            UseCost first = uses.get(0);
            UseCost last = uses.get(uses.size() - 1);
            double from = up(first.pairs().difference().median());
            double to = up(last.pairs().difference().median());
            picture.dashed(across(first, all), from, across(last, all), to, Palette.VERMILLION);
            for (UseCost use : uses) {
                Interval cost = use.pairs().difference();
                double at = across(use, all);
                picture.line(at, up(cost.low()), at, up(cost.high()), 2, Palette.BLUE);
                picture.dot(at, up(cost.median()), 4, Palette.BLUE);
            }
        }
    }
}
