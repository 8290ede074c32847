package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Narrator;

/**
 * A button with one action.
 *
 * @param words its label
 * @param action its action
 */
public record Button(String words, Runnable action) implements Widget {

    @Override
    public void draw(Canvas canvas, double x, double y, double width, boolean isHot) {
        double row = Widget.row(canvas.layout());
        canvas.panel(x, y + 2, width, row - 4, 7, Color.PANEL_LIT);
        canvas.text(
                words,
                x + width / 2,
                y + row / 2,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                Color.TEXT);
    }

    @Override
    public void describe(Narrator narrator, Plate place, boolean isHot) {
        narrator.offers(place.button(words, isHot));
    }

    @Override
    public void press(double share) {
        action.run();
    }

    @Override
    public void nudge(int direction) {
        action.run();
    }
}
