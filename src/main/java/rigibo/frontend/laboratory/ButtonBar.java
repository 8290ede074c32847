package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.widget.Spread;

import java.util.List;
import java.util.stream.IntStream;

/** Buttons side by side, of which that of the present choice is lit. */
final class ButtonBar {

    /** px. */
    static final double HEIGHT = 46;

    private static final double PADDING = 4;
    private static final double SIZE = 16;
    private static final int NOTHING = -1;

    private final List<String> titles;
    private final double x;
    private final double y;
    private final double width;

    /** Where the place of each button ends, px from the first one's left; nowhere at first. */
    private double[] ends;

    private int hot = NOTHING;

    /** A bar with its upper left corner at (x, y), px. */
    ButtonBar(List<String> titles, double x, double y, double width) {
        this.titles = titles;
        this.x = x;
        this.y = y;
        this.width = width;
        ends = new double[titles.size()];
    }

    void draw(Canvas canvas, int chosen) {
        canvas.panel(x, y, width, HEIGHT, 12, Color.PANEL);
        ends = Spread.ends(canvas, titles, SIZE, width - PADDING);
        for (int i = 0; i < titles.size(); i++) {
            Color plate = i == chosen ? Color.BRASS : i == hot ? Color.EDGE : Color.PANEL_LIT;
            double left = x + PADDING + (i == 0 ? 0 : ends[i - 1]);
            double wide = x + ends[i] - left;
            canvas.panel(left, y + PADDING, wide, HEIGHT - 2 * PADDING, 8, plate);
            canvas.text(
                    titles.get(i),
                    left + wide / 2,
                    y + HEIGHT / 2,
                    SIZE,
                    Canvas.Font.WORDS,
                    Canvas.Align.CENTRE,
                    i == chosen ? Color.DUSK_TOP : Color.TEXT);
        }
    }

    void pointerMoved(double px, double py) {
        boolean isBeside = py < y || py > y + HEIGHT || px < x;
        hot =
                IntStream.range(0, ends.length)
                        .filter(i -> !isBeside && px <= x + PADDING + ends[i])
                        .findFirst()
                        .orElse(NOTHING);
    }

    /** The button under the pointer as it last moved, or −1. */
    int hot() {
        return hot;
    }
}
