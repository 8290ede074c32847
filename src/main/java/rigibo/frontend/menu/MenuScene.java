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
import rigibo.frontend.scene.widget.Tile;
import rigibo.frontend.scene.widget.Tiles;

import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;

/**
 * The main menu: leads to the game, the levels, statistics, the settings and everything else; at
 * the bottom a few RigiBos watch the pointer.
 */
public final class MenuScene implements Scene {

    private static final double MIDDLE = WIDTH / 2.0;
    private static final double GAP = 12;
    private static final double MARGIN = 34;
    private static final double FOOT = HEIGHT - 20;

    /** Between lines of small text, px. */
    private static final double LINE = 24;

    /** The middles of the two lines of the way to play, in shares of its height. */
    private static final double VERB = 30 / 84.0;

    private static final double NEXT = 64 / 84.0;

    private final Director director;
    private final Words words;
    private final List<SceneEntry> entries;
    private final SceneEntry endless;
    private final LevelList levels;
    private MenuPlaces places = MenuPlaces.ON_A_DESK;
    private Tiles tiles;

    /** Which of the tiles quits. */
    private int quit;

    private final NoticePlate notice;
    private final Playground playground = new Playground();
    private final String tagline;

    /**
     * A menu of entries: the levels, and all other scenes.
     *
     * @param endless offered once all levels are solved
     */
    public MenuScene(Director director, List<SceneEntry> entries, SceneEntry endless) {
        this.director = director;
        words = director.words();
        this.entries = List.copyOf(entries);
        this.endless = endless;
        levels = LevelList.of(entries, director.progress());
        notice = new NoticePlate(director);
        tagline =
                levels.isComplete()
                        ? words.of("menu.complete", levels.levels().size())
                        : words.of("menu.tagline");
        layOut(0);
    }

    private void layOut(int chosen) {
        List<Tile> laid = new ArrayList<>();
        if (levels.isComplete()) {
            Grid halves = Grid.of(places.play(), 2, GAP);
            laid.add(goOn(halves.place(0)));
            laid.add(play(halves.place(1)));
        } else if (!levels.levels().isEmpty()) {
            laid.add(play(places.play()));
        }
        laid.addAll(row());
        quit = laid.size() - 1;
        laid.addAll(cards(entries.stream().filter(entry -> !entry.isLevel()).toList()));
        tiles = new Tiles(laid, chosen);
    }

    /** Leads on to what has no end. */
    private Tile goOn(Plate place) {
        String number = words.of("made.endless", director.progress().endless());
        return way(place, endless.title().apply(words), number, endless);
    }

    private Tile play(Plate at) {
        int number = levels.next();
        SceneEntry next = levels.levels().get(number);
        String verb = words.of(verb(levels));
        String place = levels.world(number) + "–" + (levels.place(number) + 1);
        String title = place + "   " + next.title().apply(words);
        return way(at, verb, title, next);
    }

    private Tile way(Plate at, String verb, String title, SceneEntry to) {
        return Tile.at(
                at,
                verb + ": " + title,
                (canvas, tile, isChosen) -> drawPlay(canvas, tile, verb, title, isChosen),
                () -> open(to));
    }

    private static String verb(LevelList levels) {
        if (levels.solved() == 0) {
            return "menu.play";
        }
        return levels.isComplete() ? "menu.again" : "menu.continue";
    }

    private static void drawPlay(
            Canvas canvas, Tile tile, String verb, String title, boolean isChosen) {
        Color plate = isChosen ? Color.of(0xFFD98F) : Color.BRASS;
        canvas.panel(tile.x(), tile.y(), tile.width(), tile.height(), 18, plate);
        if (isChosen) {
            canvas.frame(
                    tile.x() - 4, tile.y() - 4, tile.width() + 8, tile.height() + 8, 22, plate);
        }
        Print.centred(
                canvas, verb, tile.middleX(), tile.y() + VERB * tile.height(), 34, Color.DUSK_TOP);
        String fitting =
                Lines.shortened(canvas, title, 18, Canvas.Font.WORDS, tile.width() - 2 * GAP);
        double y = tile.y() + NEXT * tile.height();
        Print.centred(canvas, fitting, tile.middleX(), y, 18, Color.DUSK_TOP);
    }

    private List<Tile> row() {
        List<Tile> row = new ArrayList<>();
        row.add(button(0, "menu.levels", director::showLevels));
        row.add(button(1, "menu.statistics", () -> director.show(statistics())));
        row.add(button(2, "menu.settings", () -> director.show(new SettingsScene(director))));
        if (canQuit()) {
            row.add(button(3, "menu.quit", director::quit));
        }
        return row;
    }

    /** A handheld window has no button to quit: the system closes the game. */
    private boolean canQuit() {
        return director.canQuit() && places.equals(MenuPlaces.ON_A_DESK);
    }

    private Scene statistics() {
        return new StatisticsScene(director, entries, LocalDate.now(ZoneOffset.UTC));
    }

    private Tile button(int column, String key, Runnable action) {
        int count = canQuit() ? 4 : 3;
        Plate place = Grid.of(places.row(), count, GAP).place(column);
        return Tile.button(place, words.of(key), pressing(action));
    }

    private List<Tile> cards(List<SceneEntry> others) {
        List<Tile> cards = new ArrayList<>();
        for (SceneEntry entry : others) {
            cards.add(
                    Tile.at(
                            places.cards().place(cards.size()),
                            entry.title().apply(words) + ": " + entry.words().apply(words),
                            (canvas, tile, isChosen) -> drawCard(canvas, tile, entry, isChosen),
                            () -> open(entry)));
        }
        return cards;
    }

    private void drawCard(Canvas canvas, Tile tile, SceneEntry entry, boolean isChosen) {
        Print.plate(canvas, tile, isChosen);
        double left = tile.x() + 16;
        double width = tile.width() - 32;
        String title = entry.title().apply(words);
        if (canvas.layout().isInHand()) {
            Print.left(canvas, title, left, tile.middleY(), 20, Color.TEXT);
            return;
        }
        Print.left(canvas, title, left, tile.y() + 14, 20, Color.TEXT);
        String about =
                Lines.shortened(canvas, entry.words().apply(words), 16, Canvas.Font.WORDS, width);
        Print.left(canvas, about, left, tile.y() + 35, 16, Color.TEXT_DIM);
    }

    private Runnable pressing(Runnable action) {
        return () -> {
            director.sounds().press();
            action.run();
        };
    }

    private void open(SceneEntry entry) {
        director.sounds().press();
        director.show(entry.open().apply(director));
    }

    @Override
    public String title() {
        return "RigiBo";
    }

    @Override
    public boolean isForHands() {
        return true;
    }

    @Override
    public void step() {
        playground.step();
    }

    @Override
    public void draw(Canvas canvas) {
        fit(canvas.layout());
        playground.draw(canvas);
        Plate head = places.head();
        double middle = head.x() + head.width() / 2;
        Print.centred(canvas, "RigiBo", middle, head.y(), 92, Color.BRASS);
        double y = head.bottom();
        for (String line : Lines.of(canvas, tagline, 20, Canvas.Font.WORDS, head.width())) {
            Print.centred(canvas, line, middle, y, 20, Color.TEXT);
            y += canvas.layout().lettered(LINE);
        }
        tiles.draw(canvas);
        Plate heading = places.heading();
        Print.left(canvas, words.of("menu.physics"), heading.x(), heading.y(), 20, Color.TEXT);
        if (!canvas.layout().isInHand()) {
            double right = Scene.WIDTH - heading.x();
            Print.right(canvas, words.of("menu.help"), right, heading.y(), 16, Color.TEXT_DIM);
            drawKeys(canvas);
        }
        if (notice.isShown()) {
            notice.draw(canvas);
        }
    }

    @Override
    public void describe(Narrator narrator) {
        if (notice.isShown()) {
            notice.describe(narrator);
        } else {
            tiles.describe(narrator);
        }
    }

    private void fit(Layout layout) {
        MenuPlaces fitting = MenuPlaces.of(layout);
        if (!fitting.equals(places)) {
            places = fitting;
            layOut(tiles.chosen());
        }
    }

    private void drawKeys(Canvas canvas) {
        String keys = words.of("menu.keys");
        double needed = canvas.textWidth(keys, 16, Canvas.Font.WORDS) + 24;
        double width = Math.max(WIDTH - 2 * MARGIN, needed);
        canvas.panel(MIDDLE - width / 2, FOOT - 14, width, 28, 10, Color.PANEL);
        Print.centred(canvas, keys, MIDDLE, FOOT, 16, Color.TEXT);
    }

    @Override
    public void pointerMoved(double x, double y) {
        playground.pointerMoved(x, y);
        if (!notice.isShown()) {
            tiles.pointerMoved(x, y);
        }
    }

    @Override
    public Tap tap(double x, double y) {
        return Tap.LIFTED;
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        if (notice.isShown()) {
            notice.dismiss();
        } else {
            tiles.pointerPressed(button, x, y);
        }
    }

    @Override
    public void keyPressed(Key key) {
        if (!notice.isShown()) {
            tiles.keyPressed(key);
        } else if (key == Key.ENTER || key == Key.SPACE) {
            notice.dismiss();
        }
    }

    /** Dismisses a notice; otherwise asks by choosing the button that quits, and then quits. */
    @Override
    public boolean escaped() {
        if (notice.isShown()) {
            notice.dismiss();
            return true;
        }
        if (!canQuit()) {
            return true;
        }
        boolean isAsked = tiles.chosen() == quit;
        if (!isAsked) {
            tiles.choose(quit);
            director.say(words.of("menu.leave"));
        }
        return !isAsked;
    }
}
