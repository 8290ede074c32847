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
    private static final double BROAD = 480;
    private static final double BROAD_LEFT = (WIDTH - BROAD) / 2;
    private static final double PLAY_TOP = 190;
    private static final double PLAY_HEIGHT = 84;
    private static final double ROW_TOP = PLAY_TOP + PLAY_HEIGHT + GAP;
    private static final double ROW_HEIGHT = 48;
    private static final int ROW_COUNT = 4;
    private static final double HEADING = 368;
    private static final double CARDS_TOP = 386;
    private static final double CARD_HEIGHT = 46;
    private static final double CARD_GAP = 6;
    private static final double CARD_WIDTH = 320;
    private static final double CARDS_LEFT = (WIDTH - 2 * CARD_WIDTH - GAP) / 2;
    private static final double FOOT = HEIGHT - 20;

    private final Director director;
    private final Words words;
    private final Tiles tiles;

    /** Which of the tiles quits. */
    private final int quit;

    private final NoticePlate notice;
    private final Playground playground = new Playground();
    private final String tagline;

    /** A menu of entries: the levels, and all other scenes. */
    public MenuScene(Director director, List<SceneEntry> entries) {
        this.director = director;
        words = director.words();
        LevelList levels = LevelList.of(entries, director.progress());
        notice = new NoticePlate(director);
        tagline =
                levels.isComplete()
                        ? words.of("menu.complete", levels.levels().size())
                        : words.of("menu.tagline");
        List<Tile> laid = new ArrayList<>();
        if (!levels.levels().isEmpty()) {
            laid.add(play(levels));
        }
        laid.addAll(row(entries));
        quit = laid.size() - 1;
        laid.addAll(cards(entries.stream().filter(entry -> !entry.isLevel()).toList()));
        tiles = new Tiles(laid, 0);
    }

    private Tile play(LevelList levels) {
        int number = levels.next();
        SceneEntry next = levels.levels().get(number);
        String verb = words.of(verb(levels));
        String place = levels.world(number) + "–" + (levels.place(number) + 1);
        String title = place + "   " + next.title().apply(words);
        return new Tile(
                BROAD_LEFT,
                PLAY_TOP,
                BROAD,
                PLAY_HEIGHT,
                (canvas, tile, isChosen) -> drawPlay(canvas, tile, verb, title, isChosen),
                () -> open(next));
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
        Print.centred(canvas, verb, tile.middleX(), tile.y() + 30, 34, Color.DUSK_TOP);
        Print.centred(canvas, title, tile.middleX(), tile.y() + 64, 18, Color.DUSK_TOP);
    }

    private List<Tile> row(List<SceneEntry> entries) {
        List<Tile> row = new ArrayList<>();
        row.add(button(0, "menu.levels", director::showLevels));
        row.add(button(1, "menu.statistics", () -> director.show(statistics(entries))));
        row.add(button(2, "menu.settings", () -> director.show(new SettingsScene(director))));
        if (director.canQuit()) {
            row.add(button(3, "menu.quit", director::quit));
        }
        return row;
    }

    private Scene statistics(List<SceneEntry> entries) {
        return new StatisticsScene(director, entries, LocalDate.now(ZoneOffset.UTC));
    }

    private Tile button(int column, String key, Runnable action) {
        int count = director.canQuit() ? ROW_COUNT : ROW_COUNT - 1;
        double width = (2 * CARD_WIDTH + GAP - (count - 1) * GAP) / count;
        double x = CARDS_LEFT + column * (width + GAP);
        return new Tile(
                x,
                ROW_TOP,
                width,
                ROW_HEIGHT,
                (canvas, tile, isChosen) ->
                        Print.button(canvas, tile, this.words.of(key), isChosen),
                pressing(action));
    }

    private List<Tile> cards(List<SceneEntry> entries) {
        List<Tile> cards = new ArrayList<>();
        for (SceneEntry entry : entries) {
            int column = cards.size() % 2;
            int row = cards.size() / 2;
            cards.add(
                    new Tile(
                            CARDS_LEFT + column * (CARD_WIDTH + GAP),
                            CARDS_TOP + row * (CARD_HEIGHT + CARD_GAP),
                            CARD_WIDTH,
                            CARD_HEIGHT,
                            (canvas, tile, isChosen) -> drawCard(canvas, tile, entry, isChosen),
                            () -> open(entry)));
        }
        return cards;
    }

    private void drawCard(Canvas canvas, Tile tile, SceneEntry entry, boolean isChosen) {
        Print.plate(canvas, tile, isChosen);
        double left = tile.x() + 16;
        double width = tile.width() - 32;
        Print.left(canvas, entry.title().apply(words), left, tile.y() + 14, 20, Color.TEXT);
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
    public void step() {
        playground.step();
    }

    @Override
    public void draw(Canvas canvas) {
        playground.draw(canvas);
        Print.centred(canvas, "RigiBo", MIDDLE, 84, 92, Color.BRASS);
        Print.centred(canvas, tagline, MIDDLE, 152, 20, Color.TEXT);
        tiles.draw(canvas);
        Print.left(canvas, words.of("menu.physics"), CARDS_LEFT + 6, HEADING, 20, Color.TEXT);
        drawKeys(canvas);
        if (notice.isShown()) {
            notice.draw(canvas);
        }
    }

    private void drawKeys(Canvas canvas) {
        String keys = words.of("menu.keys");
        double needed = canvas.textWidth(keys, 16, Canvas.Font.WORDS) + 24;
        double width = Math.max(WIDTH - 2 * CARDS_LEFT, needed);
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
        if (!director.canQuit()) {
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
