package rigibo.frontend.menu;

import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.KeyBindings;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Tile;
import rigibo.frontend.scene.widget.TiledScene;
import rigibo.frontend.scene.widget.Tiles;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The page of keys for levels and demos: the player chooses an action, then presses its new key.
 */
public final class KeysScene implements TiledScene {

    /** Width of the cap on which a key is printed, px. */
    private static final double CAP = 116;

    private static final double FOOT = 750;
    private static final double LINE = 26;
    private static final double LINE_IN_HAND = 21;

    /**
     * Distance from the middle of a tile up to the action's name, and down to its key, in a
     * handheld window, px.
     */
    private static final double APART = 11;

    private final Director director;
    private KeysPlaces places = KeysPlaces.ON_A_DESK;
    private Tiles tiles;
    private Optional<Action> asked = Optional.empty();
    private String told;

    public KeysScene(Director director) {
        this.director = director;
        told = words().of("keys.choose");
        layOut(0);
    }

    private void layOut(int chosen) {
        List<Tile> laid = new ArrayList<>(actions(Action.Place.LEVEL, places.levels()));
        laid.addAll(actions(Action.Place.DEMO, places.demos()));
        laid.add(button("keys.first", places.reset(), this::reset));
        laid.add(button("keys.back", places.back(), this::leave));
        tiles = new Tiles(laid, chosen);
    }

    private Words words() {
        return director.words();
    }

    /** The actions of levels, or those that only demos have. */
    private List<Tile> actions(Action.Place place, Grid grid) {
        List<Action> actions =
                Arrays.stream(Action.values())
                        .filter(it -> it.isIn(Action.Place.LEVEL) == (place == Action.Place.LEVEL))
                        .toList();
        List<Tile> laid = new ArrayList<>();
        for (Action action : actions) {
            laid.add(
                    Tile.at(
                            grid.place(laid.size()),
                            name(action) + ": " + words().of(bindings().of(action)),
                            (canvas, tile, isChosen) -> drawKey(canvas, tile, action, isChosen),
                            () -> ask(action)));
        }
        return laid;
    }

    private Tile button(String key, Plate at, Runnable action) {
        return Tile.button(at, words().of(key), action);
    }

    private void drawKey(Canvas canvas, Tile tile, Action action, boolean isChosen) {
        boolean isAsked = asked.filter(action::equals).isPresent();
        Print.plate(canvas, tile, isChosen || isAsked);
        String key = isAsked ? words().of("keys.press") : words().of(bindings().of(action));
        if (canvas.layout().isInHand()) {
            double y = tile.middleY();
            Print.centred(canvas, name(action), tile.middleX(), y - APART, 16, Color.TEXT);
            Print.centred(canvas, key, tile.middleX(), y + APART, 16, Color.BRASS);
            return;
        }
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
        layOut(tiles.chosen());
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
    public boolean isSheet() {
        return true;
    }

    @Override
    public void step() {}

    @Override
    public void draw(Canvas canvas) {
        boolean isInHand = canvas.layout().isInHand();
        KeysPlaces now = KeysPlaces.of(canvas.layout());
        if (!now.equals(places)) {
            places = now;
            layOut(tiles.chosen());
        }
        if (!isInHand) {
            Print.centred(canvas, words().of("settings.keys"), WIDTH / 2.0, 66, 48, Color.BRASS);
        }
        drawHeading(canvas, "keys.levels", places.levels().first());
        drawHeading(canvas, "keys.demos", places.demos().first());
        tiles.draw(canvas);
        if (isInHand) {
            drawTold(canvas, 16, LINE_IN_HAND);
        } else {
            drawTold(canvas, 18, LINE);
            drawAlways(canvas, places.told());
        }
    }

    @Override
    public void describe(Narrator narrator) {
        tiles.describe(narrator);
        narrator.says(told);
    }

    private void drawHeading(Canvas canvas, String key, Plate first) {
        double above = canvas.layout().isInHand() ? 13 : 24;
        double size = canvas.layout().isInHand() ? 16 : 22;
        Print.left(canvas, words().of(key), first.x() + 6, first.y() - above, size, Color.TEXT);
    }

    private void drawTold(Canvas canvas, double size, double line) {
        Plate at = places.told();
        canvas.panel(at.x(), at.y(), at.width(), at.height(), 12, Color.PANEL);
        List<String> lines = Lines.of(canvas, told, size, Canvas.Font.WORDS, at.width() - 28);
        double middle = at.y() + at.height() / 2;
        for (int i = 0; i < lines.size(); i++) {
            double y = middle + (i - (lines.size() - 1) / 2.0) * line;
            Print.centred(canvas, lines.get(i), at.x() + at.width() / 2, y, size, Color.BRASS);
        }
    }

    /** Tells of the keys that cannot be chosen; a hand has none of them. */
    private void drawAlways(Canvas canvas, Plate told) {
        canvas.panel(told.x(), FOOT - 18, told.width(), 36, 12, Color.PANEL);
        Print.centred(canvas, words().of("keys.always"), WIDTH / 2.0, FOOT, 16, Color.TEXT);
    }

    @Override
    public Tiles tiles() {
        return tiles;
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        director.sounds().press();
        tiles.pointerPressed(button, x, y);
    }

    /** While the page waits for a key, M is an ordinary key and does not mute the window. */
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
