package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

/**
 * A plate beside a world's last cards: how much of the world is done and the medals won, or what
 * opens it.
 *
 * @param levels the list of levels
 * @param world number of the world, from 1
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

    /** From the middle of a medal to its number, which is nearer to it than to the next one, px. */
    private static final double MEDAL = 14;

    /** From the plate's upper edge to the picture, and from the text to it, px. */
    private static final double PICTURE = 14;

    private static final double GAP = 12;

    /** Lines of text above the number of levels done in the world, or above what opens it. */
    private static final int LINES_OPEN = 4;

    private static final int LINES_LOCKED = 3;

    /**
     * Draws it, with the moving picture where there is room beside the text.
     *
     * @param steps since the picture began
     */
    void draw(Canvas canvas, Plate plate, int steps, Motion motion) {
        double x = plate.x();
        double y = plate.y();
        double width = plate.width();
        double height = plate.height();
        canvas.panel(x, y, width, height, 14, Color.PANEL);
        Layout layout = canvas.layout();
        double left = x + MARGIN;
        Print.left(
                canvas,
                words.of("world." + world),
                left,
                y + layout.lettered(NAME),
                22,
                Color.BRASS);
        String told = words.of("world." + world + ".words");
        double room = width - 2 * MARGIN;
        double foot = y + height - layout.lettered(FOOT);
        if (!layout.isInHand() && fitsBeside(canvas, told, room)) {
            double pictureX = x + width - MARGIN - WorldPicture.WIDTH;
            WorldPicture.draw(canvas, world, pictureX, y + PICTURE, steps, motion);
            room -= WorldPicture.WIDTH + GAP;
        }
        double end = drawLines(canvas, told, left, y + layout.lettered(TEXT), room);
        boolean hasRoom = !layout.isInHand() || end < foot - layout.lettered(LINE) / 2;
        if (!hasRoom) {
            return;
        }
        if (levels.isWorldOpen(world)) {
            drawDone(canvas, left, x + width - MARGIN, foot);
        } else {
            Padlock.draw(canvas, left + 12, foot - 14, 0.7);
            String opens = words.of("world.opens", levels.opens(world), levels.solved());
            double opensWidth = width - 2 * MARGIN - LOCK;
            drawLines(canvas, opens, left + LOCK, foot - layout.lettered(LINE), opensWidth);
        }
    }

    /** Whether a text takes no more lines beside the picture than there is room for. */
    private boolean fitsBeside(Canvas canvas, String text, double room) {
        double width = room - WorldPicture.WIDTH - GAP;
        int lines = Lines.of(canvas, text, 16, Canvas.Font.WORDS, width).size();
        return lines <= (levels.isWorldOpen(world) ? LINES_OPEN : LINES_LOCKED);
    }

    /** Draws lines below each other; returns where the next one would be, px. */
    private static double drawLines(Canvas canvas, String text, double x, double y, double width) {
        double at = y;
        for (String line : Lines.of(canvas, text, 16, Canvas.Font.WORDS, width)) {
            Print.left(canvas, line, x, at, 16, Color.TEXT);
            at += canvas.layout().lettered(LINE);
        }
        return at;
    }

    private void drawDone(Canvas canvas, double left, double right, double y) {
        Medal[] all = Medal.values();
        double pitch = canvas.layout().lettered(MEDAL_PITCH);
        double aside = pitch / 6;
        double room = right - left - all.length * pitch;
        Print.left(canvas, done(canvas, room), left, y, 16, Color.TEXT_DIM);
        for (int i = 0; i < all.length; i++) {
            double x = right - (all.length - i) * pitch + pitch / 2;
            LevelCard.drawMedal(canvas, x - aside, y, all[i]);
            String count = String.valueOf(levels.medals(world, all[i]));
            double after = x - aside + canvas.layout().lettered(MEDAL);
            Print.left(canvas, count, after, y, 16, Color.TEXT);
        }
    }

    /** How many levels of the world are solved; without words where those are too long. */
    private String done(Canvas canvas, double room) {
        long solved = levels.solved(world);
        int of = levels.of(world).size();
        String told = words.of("menu.solved", solved, of);
        boolean fits = canvas.textWidth(told, 16, Canvas.Font.WORDS) <= room;
        return fits ? told : solved + " / " + of;
    }
}
