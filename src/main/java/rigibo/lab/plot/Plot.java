package rigibo.lab.plot;

import java.util.function.DoubleFunction;

/** The area of a plot between two scales. */
public final class Plot {

    private static final int TICK_SIZE = 13;
    private static final double TICK_GAP = 8;

    private final Picture picture;
    private final Scale across;
    private final Scale up;

    /** A plot with a scale to the right and one upwards. */
    public Plot(Picture picture, Scale across, Scale up) {
        this.picture = picture;
        this.across = across;
        this.up = up;
    }

    /** The spot of a pair of values. */
    public Spot at(double x, double y) {
        return new Spot(across.at(x), up.at(y));
    }

    /** The box between the scales. */
    public Box box() {
        return new Box(across.start(), up.end(), across.end(), up.start());
    }

    /** Draws lines at the ticks of both scales, with their values below and to the left. */
    public void grid(DoubleFunction<String> acrossWords, DoubleFunction<String> upWords) {
        Box box = box();
        for (double tick : across.ticks()) {
            double x = across.at(tick);
            picture.line(x, box.top(), x, box.bottom(), 1, Palette.GRID);
            double y = box.bottom() + TICK_GAP + TICK_SIZE;
            picture.text(x, y, Anchor.MIDDLE, TICK_SIZE, Palette.DIM, acrossWords.apply(tick));
        }
        for (double tick : up.ticks()) {
            double y = up.at(tick);
            picture.line(box.left(), y, box.right(), y, 1, Palette.GRID);
            double x = box.left() - TICK_GAP;
            picture.text(x, y + 4, Anchor.END, TICK_SIZE, Palette.DIM, upWords.apply(tick));
        }
        picture.line(box.left(), box.bottom(), box.right(), box.bottom(), 1, Palette.DIM);
        picture.line(box.left(), box.top(), box.left(), box.bottom(), 1, Palette.DIM);
    }
}
