package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Tap;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
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

    private static final double GAP = 10;

    /** Between the lines of the foot, px. */
    private static final double LINE = 23;

    /** Number of buttons above the row of the levels that are made by chance. */
    private static final int BUTTONS = 2;

    private final Director director;
    private final Words words;
    private final LevelList levels;
    private final List<SceneEntry> made;
    private LevelsPlaces places = LevelsPlaces.ON_A_DESK;
    private Tile watch;

    /** The world whose levels are shown, from 1. */
    private int world = 1;

    /** Whether the level's best run was asked for, but none was kept. */
    private boolean isMissed;

    private Tiles tiles;

    /** Since this world's levels are shown. */
    private int steps;

    /**
     * A list of the levels among some entries, with the next one to play selected.
     *
     * @param made what leads to levels that are made by chance, or by the player; three at most
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
        Grid buttons = places.buttons();
        laid.add(Tile.wayBack(buttons.place(0), words.of("menu.back"), director::showMenu));
        laid.add(Tile.button(buttons.place(1), words.of("menu.paste"), director::paste));
        Grid row = Grid.of(places.made(), Math.max(1, made.size()), GAP);
        for (int i = 0; i < made.size(); i++) {
            laid.add(made(made.get(i), row.place(i)));
        }
        for (int i = 1; i <= levels.worlds(); i++) {
            laid.add(tab(i));
        }
        levels.of(world).forEach(level -> laid.add(card(level)));
        tiles = new Tiles(laid, chosen);
        watch =
                Tile.at(
                        places.watch(),
                        words.of("replay.watch-best"),
                        this::drawWatch,
                        this::watch);
    }

    private Tile tab(int number) {
        WorldTab tab = new WorldTab(levels, number, words);
        return Tile.at(
                places.tabs().place(number - 1),
                words.of("world." + number),
                (canvas, tile, isChosen) -> tab.draw(canvas, tile, isChosen, number == world),
                () -> turnTo(number));
    }

    private Tile card(int level) {
        LevelCard card = new LevelCard(levels, level, words);
        Plate place = places.cards().place(levels.place(level));
        return Tile.at(place, card.name(), card::draw, () -> open(level));
    }

    /** Shows the levels of a world, with its tab chosen. */
    private void turnTo(int number) {
        if (number >= 1 && number <= levels.worlds()) {
            world = number;
            steps = 0;
            layOut(tabs() + number - 1);
        }
    }

    private Tile made(SceneEntry entry, Plate place) {
        return Tile.button(place, entry.title().apply(words), () -> open(entry));
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

    /** The selection among the levels made by chance. */
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
    public boolean isForHands() {
        return true;
    }

    @Override
    public void step() {
        steps++;
    }

    @Override
    public void draw(Canvas canvas) {
        fit(canvas.layout());
        boolean isInHand = canvas.layout().isInHand();
        if (!isInHand) {
            Plate title = places.title();
            Print.centred(canvas, words.of("menu.levels"), title.x(), title.y(), 36, Color.BRASS);
        }
        if (places.count() != Plate.NONE) {
            drawCount(canvas);
        }
        tiles.draw(canvas);
        if (levels.worlds() > 0) {
            new WorldPlate(levels, world, words)
                    .draw(canvas, places.world(), steps, director.settings().motion());
        }
        drawFoot(canvas);
    }

    @Override
    public void describe(Narrator narrator) {
        tiles.describe(narrator);
        if (canWatch()) {
            watch.describe(narrator, false);
        }
        narrator.says(about());
        star().ifPresent(narrator::says);
    }

    private void drawCount(Canvas canvas) {
        String key = canvas.layout().isInHand() ? "menu.solved.short" : "menu.solved";
        String count = words.of(key, levels.solved(), levels.levels().size());
        Print.right(canvas, count, places.count().x(), places.count().y(), 18, Color.TEXT);
    }

    private void drawFoot(Canvas canvas) {
        Plate foot = places.foot(canWatch());
        canvas.panel(foot.x(), foot.y(), foot.width(), foot.height(), 12, Color.PANEL);
        drawAbout(
                canvas,
                foot.x() + foot.width() / 2,
                foot.y() + foot.height() / 2,
                foot.width() - 2 * GAP);
        if (canWatch()) {
            watch.draw(canvas, false);
        }
    }

    private void fit(Layout layout) {
        LevelsPlaces fitting = LevelsPlaces.of(layout, !made.isEmpty());
        if (!fitting.equals(places)) {
            places = fitting;
            layOut(tiles.chosen());
        }
    }

    /**
     * Draws words about the selection around a point of the foot; a level with a star has a second
     * line.
     */
    private void drawAbout(Canvas canvas, double x, double y, double width) {
        Optional<String> star = isMissed ? Optional.empty() : star();
        double size = star.isPresent() || canvas.layout().isInHand() ? 16 : 18;
        double line = canvas.layout().lettered(LINE);
        List<String> lines = Lines.of(canvas, about(), size, Canvas.Font.WORDS, width);
        double top = y - (lines.size() - 1 + (star.isPresent() ? 1 : 0)) * line / 2;
        for (String words : lines) {
            Print.centred(canvas, words, x, top, size, Color.TEXT);
            top += line;
        }
        if (star.isPresent()) {
            drawStar(canvas, star.get(), x, top, width);
        }
    }

    private void drawStar(Canvas canvas, String star, double x, double y, double width) {
        String line = Lines.shortened(canvas, star, 16, Canvas.Font.WORDS, width - 24);
        double half = canvas.textWidth(line, 16, Canvas.Font.WORDS) / 2;
        Print.centred(canvas, line, x + 10, y, 16, Color.BRASS);
        if (levels.hasStar(chosenLevel().orElseThrow())) {
            Sign.star(canvas, x - half - 4, y, 8);
        } else {
            Sign.outlinedStar(canvas, x - half - 4, y, 7, 1.5, Color.BRASS);
        }
    }

    /** What the player may know about the selected level's star. */
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

    /** Only a level that was solved in its present form may have a best run. */
    private boolean canWatch() {
        OptionalInt chosen = chosenLevel();
        return chosen.isPresent() && levels.medal(chosen.getAsInt()).isPresent();
    }

    private void drawWatch(Canvas canvas, Tile tile, boolean isChosen) {
        String key = canvas.layout().isInHand() ? "replay.watch-best.short" : "replay.watch-best";
        Print.button(canvas, tile, words.of(key), isChosen);
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

    /**
     * Says what opens a level: first its world must be open, then other levels of that world must
     * be solved.
     */
    private String locked(int level) {
        return levels.isWorldOpen(world)
                ? words.of("menu.locked", levels.opensWithin(level))
                : about(world);
    }

    @Override
    public void pointerMoved(double x, double y) {
        if (!places.isOnFoot(x, y)) {
            isMissed = false;
            tiles.pointerMoved(x, y);
        }
    }

    @Override
    public Tap tap(double x, double y) {
        return Tap.LIFTED;
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        if (!places.isOnFoot(x, y)) {
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
