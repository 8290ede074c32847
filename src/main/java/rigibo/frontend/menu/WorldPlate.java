package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Print;

/**
 * A plate beside a world's last cards: what is done in it, and the medals won, or what opens it.
 *
 * @param levels the list
 * @param world which of them, from 1
 * @param words the player's
 */
record WorldPlate(LevelList levels, int world, Words words) {

    private static final double MARGIN = 18;
    private static final double NAME = 28;
    private static final double TEXT = 55;
    private static final double LINE = 22;

    /** From the plate's lower edge to the middle of its last line, px. */
    private static final double FOOT = 26;

    /** Width of a padlock before a text, px. */
    private static final double LOCK = 34;

    private static final double MEDAL_PITCH = 48;

    void draw(Canvas canvas, double x, double y, double width, double height) {
        canvas.panel(x, y, width, height, 14, Color.PANEL);
        double left = x + MARGIN;
        Print.left(canvas, words.of("world." + world), left, y + NAME, 22, Color.BRASS);
        String told = words.of("world." + world + ".words");
        double room = width - 2 * MARGIN;
        drawLines(canvas, told, left, y + TEXT, room);
        double foot = y + height - FOOT;
        if (levels.isWorldOpen(world)) {
            drawDone(canvas, left, x + width - MARGIN, foot);
        } else {
            Padlock.draw(canvas, left + 12, foot - 14, 0.7);
            String opens = words.of("world.opens", levels.opens(world), levels.solved());
            drawLines(canvas, opens, left + LOCK, foot - LINE, room - LOCK);
        }
    }

    private static void drawLines(Canvas canvas, String text, double x, double y, double width) {
        double at = y;
        for (String line : Lines.of(canvas, text, 16, Canvas.Font.WORDS, width)) {
            Print.left(canvas, line, x, at, 16, Color.TEXT);
            at += LINE;
        }
    }

    private void drawDone(Canvas canvas, double left, double right, double y) {
        String solved = words.of("menu.solved", levels.solved(world), levels.of(world).size());
        Print.left(canvas, solved, left, y, 16, Color.TEXT_DIM);
        Medal[] all = Medal.values();
        for (int i = 0; i < all.length; i++) {
            double x = right - (all.length - i) * MEDAL_PITCH + MEDAL_PITCH / 2;
            LevelCard.drawMedal(canvas, x - 8, y, all[i]);
            String count = String.valueOf(levels.medals(world, all[i]));
            Print.left(canvas, count, x + 8, y, 16, Color.TEXT);
        }
    }
}
