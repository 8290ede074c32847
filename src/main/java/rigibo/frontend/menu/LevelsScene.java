package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Sign;
import rigibo.frontend.scene.widget.Tile;
import rigibo.frontend.scene.widget.Tiles;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * The worlds as tabs, and the levels of one of them as cards with their pictures: which are open,
 * which are solved, and how well.
 */
public final class LevelsScene implements Scene {

    private static final int COLUMNS = 4;
    private static final double EDGE = 20;
    private static final double GAP = 10;
    private static final double TABS_TOP = 128;
    private static final double TOP = TABS_TOP + WorldTab.HEIGHT + GAP;
    private static final double PITCH_X = LevelCard.WIDTH + GAP;
    private static final double PITCH_Y = LevelCard.HEIGHT + GAP;

    /** Slot of the plate among those of cards, after the tenth. */
    private static final int PLATE_SLOT = 10;

    private static final double FOOT_TOP = HEIGHT - 60;
    private static final double FOOT_HEIGHT = 52;

    /** Between the lines of the foot, px. */
    private static final double LINE = 23;

    private static final double WATCH_WIDTH = 222;
    private static final double BUTTON_TOP = 22;
    private static final double BUTTON_WIDTH = 130;
    private static final double BUTTON_HEIGHT = 42;

    /** The row of the levels that are made by chance. */
    private static final double MADE_TOP = 74;

    /** Number of buttons above that row. */
    private static final int BUTTONS = 2;

    private final Director director;
    private final Words words;
    private final LevelList levels;
    private final List<SceneEntry> made;
    private final Tile watch =
            new Tile(
                    WIDTH - EDGE - WATCH_WIDTH,
                    FOOT_TOP,
                    WATCH_WIDTH,
                    FOOT_HEIGHT,
                    this::drawWatch,
                    this::watch);

    /** The world whose levels are shown, from 1. */
    private int world = 1;

    /** Whether the level's best run was asked for, but none was kept. */
    private boolean isMissed;

    private Tiles tiles;

    /**
     * A list of the levels among some entries, with the next one to play selected.
     *
     * @param made what leads to levels that are made by chance, two at most
     */
    public LevelsScene(Director director, List<SceneEntry> entries, List<SceneEntry> made) {
        this.made = List.copyOf(made);
        this.director = director;
        words = director.words();
        levels = LevelList.of(entries, director.progress());
        if (!levels.levels().isEmpty()) {
            world = levels.world(levels.next());
        }
        layOut(0);
        if (!levels.levels().isEmpty()) {
            tiles.choose(before() + levels.place(levels.next()));
        }
    }

    /** Number of tiles before those of the levels. */
    private int before() {
        return tabs() + levels.worlds();
    }

    /** Number of tiles before those of the worlds. */
    private int tabs() {
        return BUTTONS + made.size();
    }

    /** The tiles: the way back, codes, levels made by chance, the worlds, and a world's levels. */
    private void layOut(int chosen) {
        List<Tile> laid = new ArrayList<>();
        laid.add(button(EDGE, this::drawBack, director::showMenu));
        laid.add(button(EDGE + BUTTON_WIDTH + GAP, this::drawPaste, director::paste));
        double width = (WIDTH - 2 * EDGE + GAP) / Math.max(1, made.size()) - GAP;
        for (int i = 0; i < made.size(); i++) {
            laid.add(made(made.get(i), EDGE + i * (width + GAP), width));
        }
        for (int i = 1; i <= levels.worlds(); i++) {
            laid.add(tab(i));
        }
        levels.of(world).forEach(level -> laid.add(card(level)));
        tiles = new Tiles(laid, chosen);
    }

    private Tile tab(int number) {
        WorldTab tab = new WorldTab(levels, number, words);
        return new Tile(
                slotX(number - 1),
                TABS_TOP,
                WorldTab.WIDTH,
                WorldTab.HEIGHT,
                (canvas, tile, isChosen) -> tab.draw(canvas, tile, isChosen, number == world),
                () -> turnTo(number));
    }

    private Tile card(int level) {
        LevelCard card = new LevelCard(levels, level, words);
        int place = levels.place(level);
        return new Tile(
                slotX(place),
                slotY(place),
                LevelCard.WIDTH,
                LevelCard.HEIGHT,
                card::draw,
                () -> open(level));
    }

    private static double slotX(int slot) {
        return EDGE + slot % COLUMNS * PITCH_X;
    }

    private static double slotY(int slot) {
        return TOP + slot / COLUMNS * PITCH_Y;
    }

    /** Shows the levels of a world, with its tab chosen. */
    private void turnTo(int number) {
        if (number >= 1 && number <= levels.worlds()) {
            world = number;
            layOut(tabs() + number - 1);
        }
    }

    private Tile made(SceneEntry entry, double x, double width) {
        String name = entry.title().apply(words);
        return new Tile(
                x,
                MADE_TOP,
                width,
                BUTTON_HEIGHT,
                (canvas, tile, isChosen) -> Print.button(canvas, tile, name, isChosen),
                () -> open(entry));
    }

    private static Tile button(double x, Tile.Look look, Runnable action) {
        return new Tile(x, BUTTON_TOP, BUTTON_WIDTH, BUTTON_HEIGHT, look, action);
    }

    private void drawBack(Canvas canvas, Tile tile, boolean isChosen) {
        Print.button(canvas, tile, "‹  " + words.of("menu.back"), isChosen);
    }

    private void drawPaste(Canvas canvas, Tile tile, boolean isChosen) {
        Print.button(canvas, tile, words.of("menu.paste"), isChosen);
    }

    private void open(int level) {
        if (levels.isOpen(level)) {
            open(levels.levels().get(level));
        } else {
            director.sounds().refuse();
        }
    }

    private void open(SceneEntry entry) {
        director.sounds().press();
        director.show(entry.open().apply(director));
    }

    /** What is chosen among the levels made by chance. */
    private Optional<SceneEntry> chosenMade() {
        int entry = tiles.chosen() - BUTTONS;
        return entry >= 0 && entry < made.size() ? Optional.of(made.get(entry)) : Optional.empty();
    }

    private OptionalInt chosenLevel() {
        int place = tiles.chosen() - before();
        return place < 0 ? OptionalInt.empty() : OptionalInt.of(levels.of(world).get(place));
    }

    /** The world whose tab is chosen. */
    private OptionalInt chosenWorld() {
        int tab = tiles.chosen() - tabs();
        return tab < 0 || tab >= levels.worlds() ? OptionalInt.empty() : OptionalInt.of(tab + 1);
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
        if (levels.worlds() > 0) {
            new WorldPlate(levels, world, words)
                    .draw(
                            canvas,
                            slotX(PLATE_SLOT),
                            slotY(PLATE_SLOT),
                            PITCH_X + LevelCard.WIDTH,
                            LevelCard.HEIGHT);
        }
        double foot = WIDTH - 2 * EDGE - (canWatch() ? WATCH_WIDTH + GAP : 0);
        canvas.panel(EDGE, FOOT_TOP, foot, FOOT_HEIGHT, 12, Color.PANEL);
        double middle = FOOT_TOP + FOOT_HEIGHT / 2;
        drawAbout(canvas, EDGE + foot / 2, middle, foot - 2 * GAP);
        if (canWatch()) {
            watch.draw(canvas, false);
        }
    }

    /** Draws what is chosen about a point of the foot; of a level with a star a second line. */
    private void drawAbout(Canvas canvas, double x, double y, double width) {
        Optional<String> star = isMissed ? Optional.empty() : star();
        double up = star.isPresent() ? LINE / 2 : 0;
        Print.centred(canvas, about(), x, y - up, star.isPresent() ? 16 : 18, Color.TEXT);
        if (star.isPresent()) {
            String line = Lines.shortened(canvas, star.get(), 16, Canvas.Font.WORDS, width - 24);
            double half = canvas.textWidth(line, 16, Canvas.Font.WORDS) / 2;
            Print.centred(canvas, line, x + 10, y + LINE / 2, 16, Color.BRASS);
            if (levels.hasStar(chosenLevel().orElseThrow())) {
                Sign.star(canvas, x - half - 4, y + LINE / 2, 8, Color.BRASS);
            } else {
                Sign.outlinedStar(canvas, x - half - 4, y + LINE / 2, 7, 1.5, Color.BRASS);
            }
        }
    }

    /** What the player may know of the chosen level's star. */
    private Optional<String> star() {
        OptionalInt chosen = chosenLevel();
        if (chosen.isEmpty() || !levels.isOpen(chosen.getAsInt())) {
            return Optional.empty();
        }
        int level = chosen.getAsInt();
        return levels.levels()
                .get(level)
                .challenge()
                .orElseThrow()
                .star()
                .map(
                        text ->
                                levels.hasStar(level)
                                        ? text.apply(words)
                                        : words.of("puzzle.star.hidden"));
    }

    /** A level that was solved as it is now may have a run that was kept. */
    private boolean canWatch() {
        OptionalInt chosen = chosenLevel();
        return chosen.isPresent() && levels.medal(chosen.getAsInt()).isPresent();
    }

    private void drawWatch(Canvas canvas, Tile tile, boolean isChosen) {
        Print.button(canvas, tile, words.of("replay.watch-best"), isChosen);
    }

    private void watch() {
        int level = chosenLevel().orElseThrow();
        Optional<Scene> best =
                levels.levels().get(level).challenge().orElseThrow().watch().apply(director);
        best.ifPresent(director::show);
        isMissed = best.isEmpty();
    }

    private String about() {
        OptionalInt chosen = chosenLevel();
        if (chosen.isEmpty()) {
            return aboutOther();
        }
        if (isMissed) {
            return words.of("replay.none-kept");
        }
        int level = chosen.getAsInt();
        if (!levels.isOpen(level)) {
            return locked(level);
        }
        int par = levels.levels().get(level).challenge().orElseThrow().par();
        OptionalInt best = levels.done(level).fewestClicks();
        return best.isPresent()
                ? words.of("menu.best", par, best.getAsInt())
                : words.of("menu.par", par);
    }

    private String aboutOther() {
        if (chosenWorld().isPresent()) {
            return about(chosenWorld().getAsInt());
        }
        return chosenMade()
                .map(entry -> entry.words().apply(words))
                .orElseGet(() -> words.of("menu.choose"));
    }

    private String about(int number) {
        return levels.isWorldOpen(number)
                ? words.of("menu.solved", levels.solved(number), levels.of(number).size())
                : words.of("world.opens", levels.opens(number), levels.solved());
    }

    /** What opens a level: first its world, then others of that world. */
    private String locked(int level) {
        return levels.isWorldOpen(world)
                ? words.of("menu.locked", levels.opensWithin(level))
                : about(world);
    }

    @Override
    public void pointerMoved(double x, double y) {
        if (y < FOOT_TOP) {
            isMissed = false;
            tiles.pointerMoved(x, y);
        }
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        if (y < FOOT_TOP) {
            tiles.pointerPressed(button, x, y);
        } else if (button == PointerButton.LEFT && canWatch() && watch.contains(x, y)) {
            watch();
        }
    }

    @Override
    public void scrolled(double notches, double x, double y) {
        turnTo(world - (int) Math.signum(notches));
    }

    @Override
    public void keyPressed(Key key) {
        isMissed = false;
        if (key == Key.V && canWatch()) {
            watch();
            return;
        }
        switch (key) {
            case LEFT_BRACKET -> turnTo(world - 1);
            case RIGHT_BRACKET -> turnTo(world + 1);
            default -> tiles.keyPressed(key);
        }
    }
}
