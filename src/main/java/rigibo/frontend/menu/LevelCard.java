package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Sign;
import rigibo.frontend.scene.widget.Tile;

/**
 * A level in the list: its picture, number in its world and title, and a medal, perhaps a star, or
 * a lock.
 *
 * @param levels the list
 * @param level which of them, from 0
 * @param words the player's
 */
record LevelCard(LevelList levels, int level, Words words) {

    /** px. */
    static final double WIDTH = 162;

    static final double HEIGHT = 168;

    private static final double STRIP = 30;
    private static final double PICTURE = HEIGHT - STRIP;

    /** Margin around the picture, px. */
    private static final double MARGIN = 10;

    void draw(Canvas canvas, Tile tile, boolean isChosen) {
        SceneEntry entry = levels.levels().get(level);
        entry.challenge()
                .orElseThrow()
                .picture()
                .draw(
                        canvas,
                        tile.x() + MARGIN,
                        tile.y() + MARGIN,
                        WIDTH - 2 * MARGIN,
                        PICTURE - 2 * MARGIN);
        boolean isOpen = levels.isOpen(level);
        if (!isOpen) {
            drawLock(canvas, tile);
        }
        double strip = tile.y() + PICTURE;
        Color plate = isChosen ? Color.PANEL_LIT : Color.PANEL;
        canvas.panel(tile.x(), strip, WIDTH, STRIP, 10, plate);
        Color edge = isChosen ? Color.BRASS : Color.EDGE;
        canvas.frame(tile.x(), tile.y(), WIDTH, HEIGHT, 10, edge);
        String title =
                Lines.shortened(
                        canvas, entry.title().apply(words), 16, Canvas.Font.WORDS, WIDTH - 16);
        Print.centred(canvas, title, tile.middleX(), strip + STRIP / 2, 16, Color.TEXT);
        drawNumber(canvas, tile);
        if (isOpen && levels.isSolved(level)) {
            drawPrize(canvas, tile);
        }
        if (isOpen && levels.hasStar(level)) {
            double x = tile.x() + WIDTH - 54;
            canvas.panel(x - 15, tile.y() + 6, 30, 24, 8, Color.PANEL);
            Sign.star(canvas, x, tile.y() + 19, 11, Color.BRASS);
        }
    }

    private void drawNumber(Canvas canvas, Tile tile) {
        String number = String.valueOf(levels.place(level) + 1);
        canvas.panel(tile.x() + 6, tile.y() + 6, 30, 24, 8, Color.PANEL);
        Print.centred(canvas, number, tile.x() + 21, tile.y() + 18, 16, Color.TEXT);
    }

    /** Draws a veil over the picture with a padlock on it. */
    private static void drawLock(Canvas canvas, Tile tile) {
        canvas.panel(tile.x(), tile.y(), WIDTH, PICTURE, 10, Color.PANEL);
        Padlock.draw(canvas, tile.middleX(), tile.y() + PICTURE / 2, 1);
    }

    /**
     * Draws the medal with its rank, as at the end of a level; a tick if an earlier version of the
     * level was solved.
     */
    private void drawPrize(Canvas canvas, Tile tile) {
        double x = tile.x() + WIDTH - 21;
        double y = tile.y() + 18;
        canvas.panel(x - 15, y - 12, 30, 24, 8, Color.PANEL);
        levels.medal(level)
                .ifPresentOrElse(
                        medal -> drawMedal(canvas, x, y, medal),
                        () -> Sign.tick(canvas, x, y, 6, 3, Color.GOOD));
    }

    /** Draws a medal with its rank about a point. */
    static void drawMedal(Canvas canvas, double x, double y, Medal medal) {
        canvas.disc(x, y, 10, medal.color());
        String rank = String.valueOf(medal.ordinal() + 1);
        Print.centred(canvas, rank, x, y, 16, Color.DUSK_TOP);
    }
}
