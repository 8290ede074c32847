package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** Words in a scene of the menu. */
final class Print {

    private Print() {}

    static void centred(Canvas canvas, String words, double x, double y, double size, Color color) {
        canvas.text(words, x, y, size, Canvas.Font.WORDS, Canvas.Align.CENTRE, color);
    }

    static void left(Canvas canvas, String words, double x, double y, double size, Color color) {
        canvas.text(words, x, y, size, Canvas.Font.WORDS, Canvas.Align.LEFT, color);
    }

    static void right(Canvas canvas, String words, double x, double y, double size, Color color) {
        canvas.text(words, x, y, size, Canvas.Font.WORDS, Canvas.Align.RIGHT, color);
    }

    /** A button's plate with its word in the middle. */
    static void button(Canvas canvas, Tile tile, String words, boolean isChosen) {
        plate(canvas, tile, isChosen);
        centred(canvas, words, tile.middleX(), tile.middleY(), 18, Color.TEXT);
    }

    static void plate(Canvas canvas, Tile tile, boolean isChosen) {
        Color plate = isChosen ? Color.PANEL_LIT : Color.PANEL;
        canvas.panel(tile.x(), tile.y(), tile.width(), tile.height(), 12, plate);
        if (isChosen) {
            canvas.frame(tile.x(), tile.y(), tile.width(), tile.height(), 12, Color.BRASS);
        }
    }
}
