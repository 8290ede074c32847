package rigibo.lab.ablation;

import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.LinearScale;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Picture;
import rigibo.lab.report.Amount;

/** A horizontal axis in %, with a line at 0. */
record Axis(LinearScale scale) {

    /** An axis between two values, at places in px. */
    Axis(double from, double to, double left, double right) {
        this(new LinearScale(from, to, left, right));
    }

    double at(double value) {
        return scale.at(value);
    }

    double left() {
        return scale.start();
    }

    double right() {
        return scale.end();
    }

    /** Draws lines at the ticks, their values below, and the name of the axis. */
    void draw(Picture picture, double top, double bottom, String words) {
        for (double tick : scale.ticks()) {
            double x = at(tick);
            picture.line(x, top, x, bottom, 1, Palette.GRID);
            String value = Amount.percent(tick);
            picture.text(x, bottom + 18, Anchor.MIDDLE, 13, Palette.DIM, value);
        }
        picture.line(at(0), top, at(0), bottom, 1, Palette.DIM);
        double middle = (left() + right()) / 2;
        picture.text(middle, bottom + 38, Anchor.MIDDLE, 14, Palette.INK, words);
    }
}
