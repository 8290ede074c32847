package rigibo.frontend.gallery;

import rigibo.backend.Pool;
import rigibo.backend.StepReport;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Enlarged;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.widget.HandButtons;
import rigibo.frontend.scene.widget.HandFrame;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * The plates around a running exhibit: title, sentence and effects above, source and keys below.
 * Where the window has room, they stand in a column beside it.
 */
final class ExhibitPlates {

    private static final double LEFT = 8;
    private static final double WIDTH = Scene.WIDTH - 2 * LEFT;
    private static final double HEAD = 92;
    private static final double FOOT = 62;
    private static final double LINE = 24;
    private static final double INDENT = LEFT + 14;
    private static final double SIZE = 16;

    /** Width beside the source that is left for the accuracy, px. */
    private static final double BADGE = 60;

    private static final double INNER = WIDTH - 28;
    private static final double RIGHT = LEFT + WIDTH - 14;

    /** Between two plates, px. */
    private static final double GAP = 6;

    /** Height of a tab and width of a plate at the side in a desktop window, px. */
    private static final double TAB = 26;

    private static final double SIDE = 240;

    /** Wider than this a curve at the side tells no more, px. */
    private static final double WIDEST_SIDE = 330;

    private final Found found;
    private final Words words;
    private final ExhibitWords titles;
    private final HandButtons buttons = new HandButtons();

    /** Whether the whole text about the exhibit is open in a handheld window. */
    private boolean isOpen;

    private final Sides sides;

    /** The canvas of the plates in a handheld window. */
    private Optional<Enlarged> inHand = Optional.empty();

    /** Notches of the wheel that have turned no page yet. */
    private double scrolled;

    ExhibitPlates(Found found, Words words) {
        this.found = found;
        this.words = words;
        titles = new ExhibitWords(words);
        sides = new Sides(found, words);
    }

    String title() {
        return titles.title(found);
    }

    boolean isOpen(Side side) {
        return sides.isOpen(side);
    }

    /**
     * Opens or folds a plate at the side; in a handheld window it takes the place of the text about
     * the exhibit.
     */
    void toggle(Side side) {
        isOpen = false;
        sides.toggle(side);
    }

    /** A step was made. */
    void stepped(StepReport report) {
        sides.step(report);
    }

    /** A frame took so long to draw, ns. */
    void drawn(long nanos) {
        sides.drawn(nanos);
    }

    /** Forgets all places: plates that are not drawn cannot be pressed. */
    void hide() {
        buttons.clear();
        sides.hide();
    }

    void draw(
            Canvas canvas,
            Showing showing,
            String figure,
            boolean isPaused,
            List<HandButtons.Item> items,
            List<HandButtons.Item> more) {
        Layout layout = canvas.layout();
        String state = isPaused ? words.of("gallery.paused") : figure;
        sides.fit(layout.hasSource());
        inHand = Optional.empty();
        if (layout.isInHand()) {
            inHand = Optional.of(new Enlarged(canvas));
            drawInHand(inHand.get(), showing, state, items, more);
        } else if (layout.hasSource()) {
            drawBeside(canvas, showing, state);
        } else if (layout.columns() > 0) {
            drawColumn(canvas, showing, state);
        } else {
            drawOver(canvas, showing, figure, isPaused);
        }
    }

    /** Tells of the buttons of a handheld window or of the keys, and of the open plates. */
    void describe(Narrator narrator, boolean isPaused) {
        buttons.describe(narrator);
        narrator.says(titles.about(found));
        if (inHand.isEmpty()) {
            narrator.says(words.of("gallery.keys"));
        }
        if (isPaused) {
            narrator.says(words.of("gallery.paused"));
        }
    }

    /** Draws the plates in a column, with the open plate below them. */
    private void drawBeside(Canvas canvas, Showing showing, String state) {
        Layout layout = canvas.layout();
        double x = layout.sourceLeft();
        double width = layout.sourceWidth();
        double top = drawColumn(canvas, showing.pool(), state, x, width);
        double most = sides.isOpen(Side.SOURCE) ? width : Math.min(width, WIDEST_SIDE);
        Plate room = new Plate(x, top, most, Scene.HEIGHT - LEFT - top);
        sides.draw(canvas, room, showing.ghost());
    }

    /** Draws the plates in a column, with the open plate over the scene. */
    private void drawColumn(Canvas canvas, Showing showing, String state) {
        Layout layout = canvas.layout();
        double x = layout.leftColumn();
        drawColumn(canvas, showing.pool(), state, x, layout.columnWidth());
        drawSides(canvas, showing, LEFT, Scene.HEIGHT - LEFT);
    }

    /** Draws the open plate over the scene, between two heights, px. */
    private void drawSides(Canvas canvas, Showing showing, double top, double bottom) {
        double width = sides.isOpen(Side.SOURCE) ? WIDTH : SIDE * canvas.layout().type();
        double x = Scene.WIDTH - LEFT - width;
        sides.draw(canvas, new Plate(x, top, width, bottom - top), showing.ghost());
    }

    /** Draws head, keys and tabs in a column; returns where it ends, px. */
    private double drawColumn(Canvas canvas, Pool pool, String state, double x, double width) {
        ColumnPlate head = new ColumnPlate(canvas, x, width);
        head.add(title(), 24, Canvas.Font.WORDS, Color.BRASS);
        head.add(titles.about(found), SIZE, Canvas.Font.WORDS, Color.TEXT);
        head.add(effects(pool), SIZE, Canvas.Font.WORDS, Color.TEXT_DIM);
        head.add(state, 20, Canvas.Font.WORDS, Color.BRASS);
        ColumnPlate foot = new ColumnPlate(canvas, x, width);
        foot.add(found.source(), SIZE, Canvas.Font.NUMBERS, Color.TEXT);
        double inner = width - (WIDTH - INNER);
        for (String keys : Lines.ofGroups(canvas, words.of("gallery.keys"), SIZE, inner)) {
            foot.add(keys, SIZE, Canvas.Font.WORDS, Color.TEXT_DIM);
        }
        double dial = foot.draw(head.draw(LEFT) + GAP) + GAP;
        double tabs = drawRow(canvas, presets(pool), new Plate(x, dial, width, TAB));
        return drawRow(canvas, tabs(), new Plate(x, tabs, width, TAB));
    }

    /** Draws buttons side by side in a row, px; returns the upper edge of the next row. */
    private double drawRow(Canvas canvas, List<HandButtons.Item> items, Plate row) {
        Enlarged sheet = new Enlarged(canvas);
        double type = canvas.layout().type();
        double each = (row.width() - (items.size() - 1) * GAP) / items.size();
        List<Plate> places = new ArrayList<>();
        for (int i = 0; i < items.size(); i++) {
            double x = sheet.x(row.x() + i * (each + GAP));
            places.add(new Plate(x, sheet.y(row.y()), each / type, row.height() / type));
        }
        buttons.draw(sheet, places, items);
        return row.bottom() + GAP;
    }

    private static List<HandButtons.Item> presets(Pool pool) {
        Optional<Preset> present = Preset.of(pool.accuracy());
        return Arrays.stream(Preset.values())
                .map(
                        any ->
                                new HandButtons.Item(
                                        any.name(),
                                        present.filter(any::equals).isPresent(),
                                        () -> pool.accuracy(any.accuracy())))
                .toList();
    }

    private List<HandButtons.Item> tabs() {
        return Arrays.stream(Side.values())
                .filter(sides::has)
                .map(
                        side ->
                                new HandButtons.Item(
                                        words.of(side.key()),
                                        sides.isOpen(side),
                                        () -> toggle(side)))
                .toList();
    }

    /** The text about the exhibit is folded to title and figure until the player opens it. */
    private void drawInHand(
            Enlarged canvas,
            Showing showing,
            String state,
            List<HandButtons.Item> items,
            List<HandButtons.Item> more) {
        Pool pool = showing.pool();
        List<HandButtons.Item> tabs = new ArrayList<>();
        tabs.add(new HandButtons.Item(words.of("gallery.about"), isOpen, this::toggle));
        tabs.add(new HandButtons.Item(accuracy(pool), () -> turn(pool)));
        tabs.addAll(tabs());
        tabs.addAll(more);
        HandFrame frame = HandFrame.of(canvas.layout(), items.size(), tabs.size());
        buttons.draw(canvas, frame.buttons(), items);
        buttons.draw(canvas, frame.tabs(), tabs);
        if (sides.isAnyOpen()) {
            sides.draw(canvas, frame.room(), showing.ghost());
            return;
        }
        Plate at = isOpen ? frame.room() : frame.free();
        ColumnPlate plate = new ColumnPlate(canvas, at.x(), at.width());
        plate.add(title(), 20, Canvas.Font.WORDS, Color.BRASS);
        if (isOpen) {
            plate.add(titles.about(found), SIZE, Canvas.Font.WORDS, Color.TEXT);
            plate.add(effects(pool), SIZE, Canvas.Font.WORDS, Color.TEXT_DIM);
            plate.add(found.source(), SIZE, Canvas.Font.NUMBERS, Color.TEXT);
        }
        plate.add(state, SIZE, Canvas.Font.WORDS, Color.TEXT);
        plate.draw(at.y());
    }

    private void toggle() {
        isOpen = !isOpen;
        sides.fold();
    }

    private static void turn(Pool pool) {
        Preset present = Preset.of(pool.accuracy()).orElse(Preset.GAME);
        pool.accuracy(present.next().accuracy());
    }

    /** The button at a point, px, in a handheld window. */
    Optional<HandButtons.Item> button(double x, double y) {
        return buttons.at(x, y);
    }

    /** Whether a point, px, is on something that can be pressed. */
    boolean contain(double x, double y) {
        double sideX = inHand.map(sheet -> sheet.x(x)).orElse(x);
        double sideY = inHand.map(sheet -> sheet.y(y)).orElse(y);
        return button(x, y).isPresent() || sides.contains(sideX, sideY);
    }

    /** Moves on by a number of pages of the source. */
    void turn(int pages) {
        sides.turn(pages);
    }

    /** The wheel turned over the source: a page for each notch. */
    void scroll(double notches) {
        scrolled += notches;
        int whole = (int) scrolled;
        scrolled -= whole;
        turn(-whole);
    }

    private static String accuracy(Pool pool) {
        return Preset.of(pool.accuracy()).map(Preset::name).orElse("");
    }

    private void drawOver(Canvas canvas, Showing showing, String figure, boolean isPaused) {
        Pool pool = showing.pool();
        canvas.panel(LEFT, LEFT, WIDTH, HEAD, 12, Color.PANEL);
        Print.left(canvas, title(), INDENT, LEFT + 22, 24, Color.BRASS);
        String count = isPaused ? words.of("gallery.paused") : figure;
        Print.right(canvas, count, RIGHT, LEFT + 22, 20, isPaused ? Color.BRASS : Color.TEXT);
        left(canvas, titles.about(found), LEFT + 48, Color.TEXT);
        left(canvas, effects(pool), LEFT + 72, Color.TEXT_DIM);
        double foot = drawFoot(canvas, pool);
        double width = SIDE * canvas.layout().type();
        Plate row = new Plate(RIGHT + 14 - width, LEFT + HEAD + GAP, width, TAB);
        drawSides(canvas, showing, drawRow(canvas, tabs(), row), foot - GAP);
    }

    /** Returns its upper edge, px. */
    private double drawFoot(Canvas canvas, Pool pool) {
        List<String> keys = Lines.ofGroups(canvas, words.of("gallery.keys"), SIZE, INNER);
        double top = Scene.HEIGHT - LEFT - FOOT - (keys.size() - 1) * LINE;
        canvas.panel(LEFT, top, WIDTH, Scene.HEIGHT - LEFT - top, 12, Color.PANEL);
        String source = found.source();
        canvas.text(
                Lines.shortened(canvas, source, SIZE, Canvas.Font.NUMBERS, INNER - BADGE),
                INDENT,
                top + 20,
                16,
                Canvas.Font.NUMBERS,
                Canvas.Align.LEFT,
                Color.TEXT);
        Print.right(canvas, accuracy(pool), RIGHT, top + 20, 16, Color.BRASS);
        for (int i = 0; i < keys.size(); i++) {
            left(canvas, keys.get(i), top + 44 + i * LINE, Color.TEXT_DIM);
        }
        return top;
    }

    private static void left(Canvas canvas, String text, double y, Color color) {
        String fitting = Lines.shortened(canvas, text, SIZE, Canvas.Font.WORDS, INNER);
        Print.left(canvas, fitting, INDENT, y, SIZE, color);
    }

    /** The effects that the pool simulates. */
    private String effects(Pool pool) {
        return pool.effects().all().stream()
                .map(effect -> words.of("effect." + effect.title()))
                .collect(Collectors.joining(" · "));
    }
}
