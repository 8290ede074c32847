package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;

import java.util.function.Supplier;

/**
 * Shows a measured value.
 *
 * @param words its label
 * @param value the value with its unit
 */
public record Readout(String words, Supplier<String> value) implements Widget {

    /**
     * The height of a line in a handheld window, px; smaller than a button's, since it is not
     * touched.
     */
    private static final double LINE = 26;

    @Override
    public double height(Layout layout) {
        return layout.isInHand() ? layout.lettered(LINE) : ROW;
    }

    @Override
    public void draw(Canvas canvas, double x, double y, double width, boolean isHot) {
        double middle = y + height(canvas.layout()) / 2;
        canvas.text(words, x, middle, 16, Canvas.Font.WORDS, Canvas.Align.LEFT, Color.TEXT_DIM);
        canvas.text(
                value.get(),
                x + width,
                middle,
                16,
                Canvas.Font.NUMBERS,
                Canvas.Align.RIGHT,
                Color.TEXT);
    }

    @Override
    public void press(double share) {}

    @Override
    public boolean isControl() {
        return false;
    }

    @Override
    public void nudge(int direction) {}
}
