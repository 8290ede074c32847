package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.picture.LevelPicture;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Print;

import java.util.List;

/** All levels of a world on one page, for the tour: shows which ones look alike. */
final class SheetScene implements Scene {

    private static final int COLUMNS = 3;
    private static final double EDGE = 12;
    private static final double GAP = 8;
    private static final double CARD_WIDTH = (WIDTH - 2 * EDGE + GAP) / COLUMNS - GAP;
    private static final double CARD_HEIGHT = (HEIGHT - 2 * EDGE + GAP) / 4 - GAP;

    /** Height of a card's title, and margin around its picture, px. */
    private static final double STRIP = 26;

    private static final double MARGIN = 6;

    /** Slot of the world's name, after its levels. */
    private static final int NAME_SLOT = 10;

    private final Words words;
    private final List<Level> levels;
    private final int world;

    /**
     * A page.
     *
     * @param levels of the world, ten at most
     * @param world its number, from 1
     */
    SheetScene(Director director, List<Level> levels, int world) {
        words = director.words();
        this.levels = List.copyOf(levels);
        this.world = world;
    }

    @Override
    public String title() {
        return "RigiBo – " + words.of("world." + world);
    }

    @Override
    public void step() {}

    @Override
    public void draw(Canvas canvas) {
        for (int i = 0; i < levels.size(); i++) {
            drawCard(canvas, levels.get(i), i);
        }
        double x = slotX(NAME_SLOT) + 12;
        double y = slotY(NAME_SLOT);
        Print.left(canvas, words.of("world." + world), x, y + 40, 34, Color.BRASS);
        String about = words.of("world." + world + ".words");
        double line = y + 82;
        for (String text :
                Lines.of(canvas, about, 18, Canvas.Font.WORDS, 2 * CARD_WIDTH + GAP - 24)) {
            Print.left(canvas, text, x, line, 18, Color.TEXT);
            line += 25;
        }
    }

    private void drawCard(Canvas canvas, Level level, int slot) {
        double x = slotX(slot);
        double y = slotY(slot);
        double height = CARD_HEIGHT - STRIP;
        new LevelPicture(level, Double.POSITIVE_INFINITY)
                .drawOn(canvas, x, y, CARD_WIDTH, height, MARGIN);
        canvas.panel(x, y + height, CARD_WIDTH, STRIP, 8, Color.PANEL);
        canvas.frame(x, y, CARD_WIDTH, CARD_HEIGHT, 8, Color.EDGE);
        String name = slot + 1 + "  " + level.title().in(words.locale());
        Print.centred(canvas, name, x + CARD_WIDTH / 2, y + height + STRIP / 2, 16, Color.TEXT);
    }

    private static double slotX(int slot) {
        return EDGE + slot % COLUMNS * (CARD_WIDTH + GAP);
    }

    private static double slotY(int slot) {
        return EDGE + slot / COLUMNS * (CARD_HEIGHT + GAP);
    }
}
