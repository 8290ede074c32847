package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Tile;

import java.util.List;

/**
 * A world's tab above the cards: its name, and a dot for each of its levels, or a padlock.
 *
 * @param levels the list
 * @param world which of them, from 1
 * @param words the player's
 */
record WorldTab(LevelList levels, int world, Words words) {

    /**
     * The height of a tab in a desktop window, px, and the middles of its two lines in shares of
     * it.
     */
    private static final double HEIGHT = 54;

    private static final double NAME = 19 / HEIGHT;
    private static final double DOTS = 40 / HEIGHT;
    private static final double DOT = 3.5;
    private static final double DOT_PITCH = 12;

    /** Height of the line under the world that is shown, px. */
    private static final double LINE = 4;

    void draw(Canvas canvas, Tile tile, boolean isChosen, boolean isShown) {
        Print.plate(canvas, tile, isChosen);
        if (isShown) {
            canvas.panel(
                    tile.x() + 14,
                    tile.y() + tile.height() - LINE,
                    tile.width() - 28,
                    LINE,
                    2,
                    Color.BRASS);
        }
        String name =
                Lines.shortened(
                        canvas,
                        words.of("world." + world),
                        16,
                        Canvas.Font.WORDS,
                        tile.width() - 6);
        Color color = isShown ? Color.BRASS : Color.TEXT;
        Print.centred(canvas, name, tile.middleX(), tile.y() + NAME * tile.height(), 16, color);
        if (levels.isWorldOpen(world)) {
            drawDots(canvas, tile);
        } else {
            Padlock.draw(canvas, tile.middleX(), tile.y() + DOTS * tile.height() - 2, 0.55);
        }
    }

    private void drawDots(Canvas canvas, Tile tile) {
        List<Integer> all = levels.of(world);
        double x = tile.middleX() - (all.size() - 1) * DOT_PITCH / 2;
        for (int level : all) {
            Color color = levels.isSolved(level) ? Color.GOOD : Color.EDGE;
            canvas.disc(x, tile.y() + DOTS * tile.height(), DOT, color);
            x += DOT_PITCH;
        }
    }
}
