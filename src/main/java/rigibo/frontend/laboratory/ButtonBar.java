package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Spread;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** Buttons side by side, in a few rows, of which that of the present choice is lit. */
final class ButtonBar {

    /** Height of a row in a desktop window, px. */
    static final double HEIGHT = 46;

    private static final double PADDING = 4;
    private static final double SIZE = 16;
    private static final int NOTHING = -1;

    private final List<String> titles;

    /** Where the buttons are as they were last drawn. */
    private final List<Plate> places = new ArrayList<>();

    private int hot = NOTHING;

    ButtonBar(List<String> titles) {
        this.titles = List.copyOf(titles);
    }

    /** Draws it at a place, px, in a number of rows, with one of its buttons lit. */
    void draw(Canvas canvas, Plate at, int rows, int chosen) {
        places.clear();
        canvas.panel(at.x(), at.y(), at.width(), at.height(), 12, Color.PANEL);
        int inRow = (titles.size() + rows - 1) / rows;
        double height = at.height() / rows;
        for (int row = 0; row < rows; row++) {
            int from = row * inRow;
            int to = Math.min(from + inRow, titles.size());
            lay(canvas, titles.subList(from, to), at, at.y() + row * height, height);
        }
        for (int i = 0; i < titles.size(); i++) {
            draw(canvas, i, i == chosen);
        }
    }

    private void lay(Canvas canvas, List<String> row, Plate at, double y, double height) {
        double width = at.width() - PADDING;
        double least = canvas.layout().clickable(0) + PADDING;
        double[] ends =
                canvas.layout().isInHand()
                        ? Spread.ends(canvas, row, SIZE, width, least)
                        : Spread.ends(canvas, row, SIZE, width);
        for (int i = 0; i < row.size(); i++) {
            double left = at.x() + PADDING + (i == 0 ? 0 : ends[i - 1]);
            places.add(new Plate(left, y, at.x() + ends[i] - left, height));
        }
    }

    private void draw(Canvas canvas, int button, boolean isChosen) {
        Plate at = places.get(button);
        Color plate = isChosen ? Color.BRASS : button == hot ? Color.EDGE : Color.PANEL_LIT;
        double gap = canvas.layout().isInHand() ? PADDING / 2 : PADDING;
        canvas.panel(at.x(), at.y() + gap, at.width(), at.height() - 2 * gap, 8, plate);
        Color ink = isChosen ? Color.DUSK_TOP : Color.TEXT;
        double middle = at.y() + at.height() / 2;
        Print.centred(canvas, titles.get(button), at.x() + at.width() / 2, middle, SIZE, ink);
    }

    /** Tells of the buttons, where they were last drawn. */
    void describe(Narrator narrator, int chosen) {
        for (int i = 0; i < places.size(); i++) {
            Control.Kind kind = i == chosen ? Control.Kind.ON : Control.Kind.BUTTON;
            narrator.offers(places.get(i).control(titles.get(i), kind, 0.5, false));
        }
    }

    void pointerMoved(double px, double py) {
        hot =
                IntStream.range(0, places.size())
                        .filter(i -> holds(places.get(i), px, py))
                        .findFirst()
                        .orElse(NOTHING);
    }

    /** Whether a button, or the gap before it, holds a point. */
    private static boolean holds(Plate place, double px, double py) {
        return place.contains(px, py) || place.contains(px + PADDING, py);
    }

    /** The button under the pointer as it last moved, or −1. */
    int hot() {
        return hot;
    }
}
