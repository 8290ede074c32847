package rigibo.frontend.menu;

import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.KeyBindings;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Tile;
import rigibo.frontend.scene.widget.Tiles;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** What keys do in levels and demos: an action is chosen, then its key is pressed. */
public final class KeysScene implements Scene {

    private static final double EDGE = 24;
    private static final double GAP = 16;
    private static final double TOP = 150;
    private static final double ROW = 44;
    private static final double COLUMN_WIDTH = (WIDTH - 2 * EDGE - GAP) / 2;
    private static final double TILE_HEIGHT = 38;

    /** Width of the cap on which a key is printed, px. */
    private static final double CAP = 116;

    /** Middle of the plate that tells what happened, and its height, px. */
    private static final double TOLD = TOP + 10 * ROW + 34;

    private static final double TOLD_HEIGHT = 62;
    private static final double LINE = 26;
    private static final double BUTTONS = 676;
    private static final double FOOT = 750;

    private final Director director;
    private final Tiles tiles;
    private Optional<Action> asked = Optional.empty();
    private String told;

    public KeysScene(Director director) {
        this.director = director;
        told = words().of("keys.choose");
        List<Tile> laid = new ArrayList<>(column(Action.Place.LEVEL, EDGE));
        laid.addAll(column(Action.Place.DEMO, EDGE + COLUMN_WIDTH + GAP));
        laid.add(button("keys.first", EDGE, this::reset));
        laid.add(button("keys.back", EDGE + COLUMN_WIDTH + GAP, this::leave));
        tiles = new Tiles(laid, 0);
    }

    private Words words() {
        return director.words();
    }

    /** The actions of levels, or those that only demos have. */
    private List<Tile> column(Action.Place place, double x) {
        List<Action> actions =
                Arrays.stream(Action.values())
                        .filter(it -> it.isIn(Action.Place.LEVEL) == (place == Action.Place.LEVEL))
                        .toList();
        List<Tile> column = new ArrayList<>();
        for (Action action : actions) {
            column.add(
                    new Tile(
                            x,
                            TOP + column.size() * ROW,
                            COLUMN_WIDTH,
                            TILE_HEIGHT,
                            (canvas, tile, isChosen) -> drawKey(canvas, tile, action, isChosen),
                            () -> ask(action)));
        }
        return column;
    }

    private Tile button(String key, double x, Runnable action) {
        return new Tile(
                x,
                BUTTONS,
                COLUMN_WIDTH,
                TILE_HEIGHT,
                (canvas, tile, isChosen) -> Print.button(canvas, tile, words().of(key), isChosen),
                action);
    }

    private void drawKey(Canvas canvas, Tile tile, Action action, boolean isChosen) {
        boolean isAsked = asked.filter(action::equals).isPresent();
        Print.plate(canvas, tile, isChosen || isAsked);
        Print.left(canvas, name(action), tile.x() + 14, tile.middleY(), 18, Color.TEXT);
        double left = tile.x() + tile.width() - CAP - 6;
        canvas.panel(
                left,
                tile.y() + 5,
                CAP,
                tile.height() - 10,
                6,
                isAsked ? Color.BRASS : Color.DUSK_TOP);
        canvas.frame(left, tile.y() + 5, CAP, tile.height() - 10, 6, Color.EDGE);
        String key = isAsked ? words().of("keys.press") : words().of(bindings().of(action));
        Color color = isAsked ? Color.DUSK_TOP : Color.BRASS;
        Print.centred(canvas, key, left + CAP / 2, tile.middleY(), 18, color);
    }

    private String name(Action action) {
        return words().of("action." + action.title());
    }

    private KeyBindings bindings() {
        return director.settings().keys();
    }

    private void choose(KeyBindings keys) {
        director.settings(director.settings().withKeys(keys));
    }

    private void ask(Action action) {
        asked = Optional.of(action);
        told = words().of("keys.ask", name(action));
    }

    private void reset() {
        asked = Optional.empty();
        choose(KeyBindings.FIRST);
        told = words().of("keys.choose");
    }

    private void leave() {
        director.show(new SettingsScene(director));
    }

    /** Gives an action a key, or tells why not and goes on asking. */
    private void answer(Action action, Key key) {
        if (!KeyBindings.FREE.contains(key)) {
            told = words().of("keys.kept");
            return;
        }
        Set<Action> rivals = bindings().rivals(action, key);
        String others = rivals.stream().map(this::name).collect(Collectors.joining(", "));
        Optional<KeyBindings> changed = bindings().with(action, key);
        if (changed.isEmpty()) {
            told = words().of("keys.refused", others);
            return;
        }
        String had = words().of(bindings().of(action));
        choose(changed.get());
        asked = Optional.empty();
        told =
                rivals.isEmpty()
                        ? words().of("keys.told", name(action), words().of(key))
                        : words().of("keys.swapped", name(action), words().of(key), others, had);
    }

    @Override
    public String title() {
        return "RigiBo – " + words().of("settings.keys");
    }

    @Override
    public void step() {}

    @Override
    public void draw(Canvas canvas) {
        Print.centred(canvas, words().of("settings.keys"), WIDTH / 2.0, 66, 48, Color.BRASS);
        double right = EDGE + COLUMN_WIDTH + GAP;
        Print.left(canvas, words().of("keys.levels"), EDGE + 6, 126, 22, Color.TEXT);
        Print.left(canvas, words().of("keys.demos"), right + 6, 126, 22, Color.TEXT);
        tiles.draw(canvas);
        drawTold(canvas);
    }

    private void drawTold(Canvas canvas) {
        double width = WIDTH - 2 * EDGE;
        canvas.panel(EDGE, TOLD - TOLD_HEIGHT / 2, width, TOLD_HEIGHT, 12, Color.PANEL);
        List<String> lines = Lines.of(canvas, told, 18, Canvas.Font.WORDS, width - 28);
        for (int i = 0; i < lines.size(); i++) {
            double y = TOLD + (i - (lines.size() - 1) / 2.0) * LINE;
            Print.centred(canvas, lines.get(i), WIDTH / 2.0, y, 18, Color.BRASS);
        }
        canvas.panel(EDGE, FOOT - 18, width, 36, 12, Color.PANEL);
        Print.centred(canvas, words().of("keys.always"), WIDTH / 2.0, FOOT, 16, Color.TEXT);
    }

    @Override
    public void pointerMoved(double x, double y) {
        tiles.pointerMoved(x, y);
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        director.sounds().press();
        tiles.pointerPressed(button, x, y);
    }

    /** While a key is asked for, M is one that could be meant, and not the window's. */
    @Override
    public boolean isTyping() {
        return asked.isPresent();
    }

    @Override
    public void keyPressed(Key key) {
        asked.ifPresentOrElse(action -> answer(action, key), () -> tiles.keyPressed(key));
    }

    /** Leaves a question, then the page. */
    @Override
    public boolean escaped() {
        if (asked.isEmpty()) {
            leave();
        }
        asked = Optional.empty();
        told = words().of("keys.choose");
        return true;
    }
}
