package rigibo.frontend.gallery;

import rigibo.backend.Pool;
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
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * The plates around a running exhibit: title, sentence and effects above, source and keys below; in
 * a column beside it where the window has room for one.
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

    private static final String BETWEEN_KEYS = "   ";

    private final Found found;
    private final Words words;
    private final ExhibitWords titles;
    private final HandButtons buttons = new HandButtons();

    /** Whether all is said of it in a hand. */
    private boolean isOpen;

    private boolean isInHand;

    ExhibitPlates(Found found, Words words) {
        this.found = found;
        this.words = words;
        titles = new ExhibitWords(words);
    }

    String title() {
        return titles.title(found);
    }

    void draw(
            Canvas canvas,
            Pool pool,
            String figure,
            boolean isPaused,
            List<HandButtons.Item> items,
            List<HandButtons.Item> more) {
        buttons.clear();
        isInHand = canvas.layout().isInHand();
        if (isInHand) {
            drawInHand(
                    new Enlarged(canvas),
                    pool,
                    isPaused ? words.of("gallery.paused") : figure,
                    items,
                    more);
        } else if (canvas.layout().columns() > 0) {
            drawColumn(canvas, pool, isPaused ? words.of("gallery.paused") : figure);
        } else {
            drawOver(canvas, pool, figure, isPaused);
        }
    }

    /** Tells of the buttons of a hand, or of the keys, and of what is shown. */
    void describe(Narrator narrator, boolean isPaused) {
        buttons.describe(narrator);
        narrator.says(titles.about(found));
        if (!isInHand) {
            narrator.says(words.of("gallery.keys"));
        }
        if (isPaused) {
            narrator.says(words.of("gallery.paused"));
        }
    }

    private void drawColumn(Canvas canvas, Pool pool, String state) {
        Layout layout = canvas.layout();
        ColumnPlate head = new ColumnPlate(canvas, layout.leftColumn(), layout.columnWidth());
        head.add(title(), 24, Canvas.Font.WORDS, Color.BRASS);
        head.add(titles.about(found), SIZE, Canvas.Font.WORDS, Color.TEXT);
        head.add(effects(pool), SIZE, Canvas.Font.WORDS, Color.TEXT_DIM);
        head.add(state, 20, Canvas.Font.WORDS, Color.BRASS);
        ColumnPlate foot = new ColumnPlate(canvas, layout.leftColumn(), layout.columnWidth());
        foot.add(found.source(), SIZE, Canvas.Font.NUMBERS, Color.TEXT);
        foot.add(accuracy(pool), SIZE, Canvas.Font.WORDS, Color.BRASS);
        for (String key : words.of("gallery.keys").split(BETWEEN_KEYS)) {
            foot.add(key, SIZE, Canvas.Font.WORDS, Color.TEXT_DIM);
        }
        foot.draw(head.draw(LEFT) + GAP);
    }

    /** What is said of it is folded to its title and figure until it is asked for. */
    private void drawInHand(
            Enlarged canvas,
            Pool pool,
            String state,
            List<HandButtons.Item> items,
            List<HandButtons.Item> more) {
        List<HandButtons.Item> tabs = new ArrayList<>();
        tabs.add(new HandButtons.Item(words.of("gallery.about"), isOpen, this::toggle));
        tabs.add(new HandButtons.Item(accuracy(pool), () -> turn(pool)));
        tabs.addAll(more);
        HandFrame frame = HandFrame.of(canvas.layout(), items.size(), tabs.size());
        buttons.draw(canvas, frame.buttons(), items);
        buttons.draw(canvas, frame.tabs(), tabs);
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
    }

    private static void turn(Pool pool) {
        Preset present = Preset.of(pool.accuracy()).orElse(Preset.GAME);
        pool.accuracy(present.next().accuracy());
    }

    /** The button at a point, px, in a hand. */
    Optional<HandButtons.Item> button(double x, double y) {
        return buttons.at(x, y);
    }

    private static String accuracy(Pool pool) {
        return Preset.of(pool.accuracy()).map(Preset::name).orElse("");
    }

    private void drawOver(Canvas canvas, Pool pool, String figure, boolean isPaused) {
        canvas.panel(LEFT, LEFT, WIDTH, HEAD, 12, Color.PANEL);
        Print.left(canvas, title(), INDENT, LEFT + 22, 24, Color.BRASS);
        String count = isPaused ? words.of("gallery.paused") : figure;
        Print.right(canvas, count, RIGHT, LEFT + 22, 20, isPaused ? Color.BRASS : Color.TEXT);
        left(canvas, titles.about(found), LEFT + 48, Color.TEXT);
        left(canvas, effects(pool), LEFT + 72, Color.TEXT_DIM);
        drawFoot(canvas, pool);
    }

    private void drawFoot(Canvas canvas, Pool pool) {
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
