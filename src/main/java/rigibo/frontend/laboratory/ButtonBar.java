package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.List;

/** Buttons side by side, of which that of the present choice is lit. */
final class ButtonBar {

    /** px. */
    static final double HEIGHT = 46;

    private static final double PADDING = 4;
    private static final int NOTHING = -1;

    private final List<String> titles;
    private final double x;
    private final double y;
    private final double width;
    private int hot = NOTHING;

    /** A bar with its upper left corner at (x, y), px. */
    ButtonBar(List<String> titles, double x, double y, double width) {
        this.titles = titles;
        this.x = x;
        this.y = y;
        this.width = width;
    }

    void draw(Canvas canvas, int chosen) {
        canvas.panel(x, y, width, HEIGHT, 12, Color.PANEL);
        for (int i = 0; i < titles.size(); i++) {
            Color plate = i == chosen ? Color.BRASS : i == hot ? Color.EDGE : Color.PANEL_LIT;
            double left = x + PADDING + i * pitch();
            double wide = pitch() - PADDING;
            canvas.panel(left, y + PADDING, wide, HEIGHT - 2 * PADDING, 8, plate);
            canvas.text(
                    titles.get(i),
                    left + wide / 2,
                    y + HEIGHT / 2,
                    16,
                    Canvas.Font.WORDS,
                    Canvas.Align.CENTRE,
                    i == chosen ? Color.DUSK_TOP : Color.TEXT);
        }
    }

    private double pitch() {
        return (width - PADDING) / titles.size();
    }

    void pointerMoved(double px, double py) {
        boolean isInside = py >= y && py <= y + HEIGHT && px >= x && px <= x + width;
        int last = titles.size() - 1;
        hot = isInside ? (int) Math.min(last, Math.max(0, (px - x - PADDING) / pitch())) : NOTHING;
    }

    /** The button under the pointer as it last moved, or −1. */
    int hot() {
        return hot;
    }
}
