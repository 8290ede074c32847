package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.Badge;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

import java.util.List;

/** Says how many times as long the right half takes, and how fast the laboratory runs. */
final class StatusPlate {

    /** Height of a line in a handheld window, px. */
    private static final double LINE = 21;

    private final Words words;
    private final HalfView left;
    private final HalfView right;

    /** Share of real time at which the loop runs. */
    private double pace = 1;

    StatusPlate(Words words, HalfView left, HalfView right) {
        this.words = words;
        this.left = left;
        this.right = right;
    }

    void paced(double share) {
        pace = share;
    }

    /** In one line. */
    void draw(Canvas canvas, Plate at, boolean isPaused) {
        canvas.panel(at.x(), at.y(), at.width(), at.height(), 12, Color.PANEL);
        double middle = at.y() + at.height() / 2;
        Print.left(canvas, ratio(), at.x() + 12, middle, 16, Color.TEXT);
        Print.right(canvas, state(isPaused), at.right() - 12, middle, 16, Color.BRASS);
    }

    /** In as many lines as a narrow plate needs. */
    void drawInHand(Canvas canvas, Plate at, boolean isPaused) {
        canvas.panel(at.x(), at.y(), at.width(), at.height(), 12, Color.PANEL);
        String said = ratio() + " · " + state(isPaused);
        List<String> lines = Lines.of(canvas, said, 16, Canvas.Font.WORDS, at.width() - 24);
        double y = at.y() + at.height() / 2 - (lines.size() - 1) * LINE / 2;
        for (String line : lines) {
            Print.left(canvas, line, at.x() + 12, y, 16, Color.TEXT);
            y += LINE;
        }
    }

    private String state(boolean isPaused) {
        return isPaused ? words.of("badge.paused") : new Badge(words).pace(pace);
    }

    private String ratio() {
        double one = left.medianMillis();
        double other = right.medianMillis();
        if (one == 0 || other == 0) {
            return words.of("laboratory.ask");
        }
        String times = words.number("%.2f", other / one);
        return words.of("laboratory.ratio", right.name(), times, left.name());
    }
}
