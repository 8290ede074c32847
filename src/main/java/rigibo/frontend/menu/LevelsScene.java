package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;

/** All levels as cards with their pictures: which are open, which solved, and how well. */
public final class LevelsScene implements Scene {

    private static final int COLUMNS = 4;
    private static final int ROWS = 4;
    private static final double EDGE = 20;
    private static final double GAP = 10;
    private static final double TOP = 84;
    private static final double PITCH_X = LevelCard.WIDTH + GAP;
    private static final double PITCH_Y = LevelCard.HEIGHT + GAP;
    private static final double FOOT_TOP = HEIGHT - 58;

    private final Director director;
    private final Words words;
    private final LevelList levels;
    private int firstRow;
    private Tiles tiles;

    /** A list of the levels among some entries; the one to go on with is chosen. */
    public LevelsScene(Director director, List<SceneEntry> entries) {
        this.director = director;
        words = director.words();
        levels = LevelList.of(entries, director.progress());
        layOut(levels.levels().isEmpty() ? 0 : levels.next() + 1);
        bringIntoSight();
    }

    /** The way back is the first tile, the levels follow; rows out of sight have none. */
    private void layOut(int chosen) {
        List<Tile> laid = new ArrayList<>();
        laid.add(new Tile(EDGE, 22, 130, 42, this::drawBack, director::showMenu));
        for (int i = 0; i < levels.levels().size(); i++) {
            int level = i;
            laid.add(
                    new Tile(
                            EDGE + i % COLUMNS * PITCH_X,
                            TOP + (i / COLUMNS - firstRow) * PITCH_Y,
                            LevelCard.WIDTH,
                            LevelCard.HEIGHT,
                            (canvas, tile, isChosen) -> drawCard(canvas, tile, level, isChosen),
                            () -> open(level)));
        }
        tiles = new Tiles(laid, chosen);
    }

    private void drawBack(Canvas canvas, Tile tile, boolean isChosen) {
        Print.button(canvas, tile, "‹  " + words.of("menu.back"), isChosen);
    }

    private void drawCard(Canvas canvas, Tile tile, int level, boolean isChosen) {
        if (isInSight(level)) {
            new LevelCard(levels, level, words).draw(canvas, tile, isChosen);
        }
    }

    private boolean isInSight(int level) {
        int row = level / COLUMNS - firstRow;
        return row >= 0 && row < ROWS;
    }

    private void open(int level) {
        if (levels.isOpen(level)) {
            director.sounds().press();
            director.show(levels.levels().get(level).open().apply(director));
        } else {
            director.sounds().refuse();
        }
    }

    private OptionalInt chosenLevel() {
        return tiles.chosen() == 0 ? OptionalInt.empty() : OptionalInt.of(tiles.chosen() - 1);
    }

    private void bringIntoSight() {
        chosenLevel().ifPresent(level -> scrollTo(rowToShow(level / COLUMNS)));
    }

    private int rowToShow(int row) {
        return Math.max(row - ROWS + 1, Math.min(row, firstRow));
    }

    private void scrollTo(int row) {
        int last = (levels.levels().size() - 1) / COLUMNS;
        int wanted = Math.max(0, Math.min(row, last - ROWS + 1));
        if (wanted != firstRow) {
            firstRow = wanted;
            layOut(tiles.chosen());
        }
    }

    @Override
    public String title() {
        return "RigiBo – " + words.of("menu.levels");
    }

    @Override
    public void step() {}

    @Override
    public void draw(Canvas canvas) {
        Print.centred(canvas, words.of("menu.levels"), WIDTH / 2.0, 44, 36, Color.BRASS);
        String count = words.of("menu.solved", levels.solved(), levels.levels().size());
        Print.right(canvas, count, WIDTH - EDGE, 46, 18, Color.TEXT);
        tiles.draw(canvas);
        canvas.panel(EDGE, FOOT_TOP, WIDTH - 2 * EDGE, 40, 12, Color.PANEL);
        Print.centred(canvas, about(), WIDTH / 2.0, FOOT_TOP + 20, 18, Color.TEXT);
    }

    private String about() {
        OptionalInt chosen = chosenLevel();
        if (chosen.isEmpty()) {
            return words.of("menu.choose");
        }
        int level = chosen.getAsInt();
        if (!levels.isOpen(level)) {
            return words.of("menu.locked", level);
        }
        int par = levels.levels().get(level).challenge().orElseThrow().par();
        OptionalInt best = levels.done(level).fewestClicks();
        return best.isPresent()
                ? words.of("menu.best", par, best.getAsInt())
                : words.of("menu.par", par);
    }

    @Override
    public void pointerMoved(double x, double y) {
        if (y < FOOT_TOP) {
            tiles.pointerMoved(x, y);
        }
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        if (y < FOOT_TOP) {
            tiles.pointerPressed(button, x, y);
        }
    }

    @Override
    public void scrolled(double notches, double x, double y) {
        scrollTo(firstRow - (int) Math.signum(notches));
    }

    @Override
    public void keyPressed(Key key) {
        tiles.keyPressed(key);
        bringIntoSight();
    }
}
