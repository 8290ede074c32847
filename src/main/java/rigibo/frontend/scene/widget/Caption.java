package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.List;

/**
 * The title of a card, on a strip along its foot that is as high as its lines need.
 *
 * @param lines of the title
 * @param strip height of a strip with one line, px
 * @param pitch distance between two lines, px
 */
public record Caption(List<String> lines, double strip, double pitch) {

    private static final double SIZE = 16;
    private static final double STRIP = 30;
    private static final double PITCH = 22;

    /** Room beside the words, px: with large letters little is left of it by long words. */
    private static final double ASIDE = 4;

    /** The caption of a card. */
    public static Caption of(Canvas canvas, String title, Tile card) {
        double room = card.width() - 2 * ASIDE;
        return new Caption(
                Lines.of(canvas, title, SIZE, Canvas.Font.WORDS, room),
                canvas.layout().lettered(STRIP),
                canvas.layout().lettered(PITCH));
    }

    /** Height of the strip, px. */
    public double height() {
        return strip + (lines.size() - 1) * pitch;
    }

    /** Draws it, with a frame round the whole card. */
    public void draw(Canvas canvas, Tile card, boolean isChosen) {
        double top = card.y() + card.height() - height();
        Color plate = isChosen ? Color.PANEL_LIT : Color.PANEL;
        canvas.panel(card.x(), top, card.width(), height(), 10, plate);
        Color edge = isChosen ? Color.BRASS : Color.EDGE;
        canvas.frame(card.x(), card.y(), card.width(), card.height(), 10, edge);
        double middle = top + strip / 2;
        for (String line : lines) {
            Print.centred(canvas, line, card.middleX(), middle, SIZE, Color.TEXT);
            middle += pitch;
        }
    }
}
