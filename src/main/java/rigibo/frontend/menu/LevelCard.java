package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Caption;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Sign;
import rigibo.frontend.scene.widget.Tile;

import java.util.ArrayList;
import java.util.List;

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

    /** Margin around the picture, px. */
    private static final double MARGIN = 10;

    /** The card in words. How to open a level is told only for the selected card. */
    String name() {
        List<String> parts = new ArrayList<>();
        parts.add(levels.place(level) + 1 + " " + levels.levels().get(level).title().apply(words));
        levels.medal(level).ifPresent(medal -> parts.add(words.of(StatisticsScene.name(medal))));
        if (levels.hasStar(level)) {
            parts.add(words.of("puzzle.short.star"));
        }
        return String.join(", ", parts);
    }

    void draw(Canvas canvas, Tile tile, boolean isChosen) {
        String title = levels.levels().get(level).title().apply(words);
        Caption caption = Caption.of(canvas, title, tile);
        double picture = tile.height() - caption.height();
        SceneEntry entry = levels.levels().get(level);
        entry.challenge()
                .orElseThrow()
                .picture()
                .drawOn(canvas, tile.x(), tile.y(), tile.width(), picture, MARGIN);
        boolean isOpen = levels.isOpen(level);
        if (!isOpen) {
            drawLock(canvas, tile, picture);
        }
        caption.draw(canvas, tile, isChosen);
        drawNumber(canvas, tile);
        if (isOpen && levels.isSolved(level)) {
            drawPrize(canvas, tile);
        }
        if (isOpen && levels.hasStar(level)) {
            double x = tile.x() + tile.width() - 24 - canvas.layout().lettered(30);
            canvas.panel(x - 15, tile.y() + 6, 30, 24, 8, Color.PANEL);
            Sign.star(canvas, x, tile.y() + 19, 11);
        }
    }

    private void drawNumber(Canvas canvas, Tile tile) {
        String number = String.valueOf(levels.place(level) + 1);
        double width = canvas.layout().lettered(30);
        double height = canvas.layout().lettered(24);
        double left = tile.x() + 6;
        double top = tile.y() + 6;
        canvas.panel(left, top, width, height, 8, Color.PANEL);
        Print.centred(canvas, number, left + width / 2, top + height / 2, 16, Color.TEXT);
    }

    /** Draws a veil over the picture with a padlock on it. */
    private static void drawLock(Canvas canvas, Tile tile, double picture) {
        canvas.panel(tile.x(), tile.y(), tile.width(), picture, 10, Color.PANEL);
        Padlock.draw(canvas, tile.middleX(), tile.y() + picture / 2, 1);
    }

    /**
     * Draws the medal with its rank, as at the end of a level; a tick if an earlier version of the
     * level was solved.
     */
    private void drawPrize(Canvas canvas, Tile tile) {
        double width = canvas.layout().lettered(30);
        double height = canvas.layout().lettered(24);
        double x = tile.x() + tile.width() - 6 - width / 2;
        double y = tile.y() + 6 + height / 2;
        canvas.panel(x - width / 2, y - height / 2, width, height, 8, Color.PANEL);
        levels.medal(level)
                .ifPresentOrElse(
                        medal -> drawMedal(canvas, x, y, medal),
                        () -> Sign.tick(canvas, x, y, 6, 3, Color.GOOD));
    }

    /** Draws a medal with its rank about a point. */
    static void drawMedal(Canvas canvas, double x, double y, Medal medal) {
        canvas.disc(x, y, canvas.layout().lettered(10), medal.color());
        String rank = String.valueOf(medal.ordinal() + 1);
        Print.centred(canvas, rank, x, y, 16, Color.DUSK_TOP);
    }
}
