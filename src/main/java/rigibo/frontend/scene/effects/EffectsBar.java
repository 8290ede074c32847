package rigibo.frontend.scene.effects;

import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;

/**
 * The effects of a scene as chips, lit when simulated. The pointer over a chip shows what the
 * effect does in the scene and what it costs; a click switches it, which is marked as an
 * experiment.
 */
public final class EffectsBar {

    private static final double PADDING = 10;

    /** Rows of chips where the bar is as wide as a scene, and at most where it is narrow. */
    private static final int ROWS = 2;

    private static final int MOST_ROWS = 10;

    /** Width from which on two rows are enough, px. */
    private static final double WIDE = 500;

    /** Number of lines kept for words in a handheld window. */
    private static final int LINES_IN_HAND = 7;

    /** Lines of words, and where text is enlarged. */
    private static final int SHORT_LINES = 2;

    private static final int MOST_LINES = 4;

    /** A line of words, px. */
    private static final double LINE = 22;

    private static final double INDENT = PADDING + 4;
    private static final double SIZE = 16;

    /** Height where it is as wide as a scene and its words are short, px. */
    public static final double HEIGHT = height(Chip.HEIGHT, ROWS, SHORT_LINES);

    private final SceneEffects scene;
    private final Words words;
    private final CostWords said;
    private final CostMeter meter;
    private List<Chip> chips = List.of();
    private Plate plate = Plate.NONE;
    private double pointerX = -1;
    private double pointerY = -1;

    /** Why the last click changed nothing; empty otherwise. */
    private String refusal = "";

    /** The bar of a scene, with costs from a meter. */
    public EffectsBar(SceneEffects scene, CostMeter meter) {
        this.scene = scene;
        words = scene.words();
        said = new CostWords(words);
        this.meter = meter;
    }

    /** Call when a frame was drawn: goes on measuring. */
    public void turn() {
        List<Effect> shown = chips.stream().map(Chip::effect).toList();
        meter.turn(scene.pool(), shown, hot().map(Chip::effect));
    }

    /** Draws the bar with its upper left corner at a point, px, so wide. */
    public void draw(Canvas canvas, double x, double y, double width) {
        int lines = width >= WIDE ? reserved(canvas.layout()) : SHORT_LINES;
        lay(canvas, width, most(width), lines, laid -> new Plate(x, y, width, laid));
    }

    /**
     * Draws the bar at the upper edge of a room in a handheld window, with as many chips as fit
     * into it.
     */
    public void draw(Canvas canvas, Plate room) {
        double chip = Chip.height(canvas.layout());
        int rows = MOST_ROWS;
        while (rows > 1 && height(chip, rows, LINES_IN_HAND) > room.height()) {
            rows--;
        }
        double width = room.width();
        lay(canvas, width, rows, LINES_IN_HAND, laid -> new Plate(room.x(), room.y(), width, laid));
    }

    /**
     * Draws the bar with its lower left corner at a point, px, so wide; as high for all that it
     * says, so that no chip slips away from under the pointer.
     */
    public void drawAbove(Canvas canvas, double x, double bottom, double width) {
        lay(
                canvas,
                width,
                most(width),
                reserved(canvas.layout()),
                laid -> new Plate(x, bottom - laid, width, laid));
    }

    /** Its height where it is as wide as a scene, whatever it says. */
    public static double height(Layout layout) {
        return height(Chip.height(layout), ROWS, reserved(layout));
    }

    /** Lines that are left for its words, of which more take two where text is enlarged. */
    private static int reserved(Layout layout) {
        return layout.type() > 1 ? MOST_LINES : SHORT_LINES;
    }

    /** Most rows of chips. */
    private static int most(double width) {
        return width >= WIDE ? ROWS : MOST_ROWS;
    }

    private void lay(
            Canvas canvas, double width, int most, int lines, DoubleFunction<Plate> place) {
        List<Chip> laid = ChipLayout.of(scene, canvas, width - 2 * PADDING, most);
        int rows = width >= WIDE ? ROWS : ChipLayout.rows(laid);
        List<String> what = lines(canvas, what(), width);
        List<String> cost = lines(canvas, cost(), width);
        int said = what.size() + cost.size() + (isMarked() && width < WIDE ? 1 : 0);
        double each = Chip.height(canvas.layout());
        plate = place.apply(height(each, rows, Math.max(lines, said)));
        chips =
                laid.stream()
                        .map(chip -> chip.movedBy(plate.x() + PADDING, plate.y() + PADDING))
                        .toList();
        draw(canvas, plate.y() + height(each, rows, 0) - 6 + LINE / 2, what, cost);
    }

    private static double height(double chip, int rows, int lines) {
        double chips = rows * (chip + ChipLayout.GAP) - ChipLayout.GAP;
        return PADDING + chips + 6 + lines * LINE + 6;
    }

    private static List<String> lines(Canvas canvas, String text, double width) {
        return Lines.of(canvas, text, SIZE, Canvas.Font.WORDS, width - INDENT - PADDING / 2);
    }

    private void draw(Canvas canvas, double firstLine, List<String> what, List<String> cost) {
        boolean isExperiment = !scene.marking().isEmpty();
        canvas.panel(plate.x(), plate.y(), plate.width(), plate.height(), 12, Color.PANEL);
        if (isExperiment) {
            canvas.frame(plate.x(), plate.y(), plate.width(), plate.height(), 12, Color.BAD);
        }
        Effects calledFor = scene.calledFor();
        chips.forEach(chip -> draw(canvas, chip, calledFor));
        words(canvas, what, firstLine, refusal.isEmpty() ? Color.TEXT : Color.BAD);
        double second = firstLine + what.size() * LINE;
        words(canvas, cost, second, Color.BRASS);
        if (isMarked()) {
            drawMark(canvas, plate.bottom() - 6 - LINE / 2);
        }
    }

    private void draw(Canvas canvas, Chip chip, Effects calledFor) {
        Estimate cost = meter.cost(chip.effect());
        // Nothing is said of a sleeping scene: it costs nothing, and the share of an awake step
        // does not apply to it.
        boolean isOfStep = cost.isKnown() && meter.step() > 0 && !meter.hasWoken();
        double share = isOfStep ? cost.mean() / meter.step() : 0;
        boolean isCalledFor = calledFor.declares(chip.effect().getClass());
        chip.draw(canvas, isLit(chip), isLit(chip) != isCalledFor, share);
    }

    private boolean isMarked() {
        return !scene.marking().isEmpty() && hot().isPresent();
    }

    /** While a chip is explained, the experiment stays marked in a corner. */
    private void drawMark(Canvas canvas, double y) {
        canvas.text(
                words.of("effect.experiment"),
                plate.right() - INDENT,
                y,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.RIGHT,
                Color.BAD);
    }

    private void words(Canvas canvas, List<String> lines, double y, Color color) {
        for (int i = 0; i < lines.size(); i++) {
            Print.left(canvas, lines.get(i), plate.x() + INDENT, y + i * LINE, SIZE, color);
        }
    }

    private boolean isLit(Chip chip) {
        return scene.pool().effects().declares(chip.effect().getClass());
    }

    private boolean isCalledFor(Chip chip) {
        return scene.calledFor().declares(chip.effect().getClass());
    }

    private String what() {
        if (!refusal.isEmpty()) {
            return refusal;
        }
        String idle = scene.marking().isEmpty() ? words.of("effect.idle") : scene.marking();
        return hot().map(this::what).orElse(idle);
    }

    private String what(Chip chip) {
        String key =
                isCalledFor(chip)
                        ? isLit(chip) ? "effect.called" : "effect.left-out"
                        : isLit(chip) ? "effect.tried" : "effect.offered";
        return words.of(key, chip.title(), chip.reason().words());
    }

    private String cost() {
        String step = said.ofStep(meter.step());
        if (!refusal.isEmpty()) {
            return step;
        }
        return hot().map(chip -> cost(chip) + "; " + step).orElse(words.of("cost.share", step));
    }

    private String cost(Chip chip) {
        Estimate cost = meter.cost(chip.effect());
        Switching switching = Switching.of(scene.pool().effects(), chip.effect());
        if (switching.effects().isEmpty()) {
            return refusal(switching);
        }
        String price = isLit(chip) ? said.ofLit(cost) : said.ofUnlit(cost);
        boolean isOfWoken = meter.hasWoken() && !(chip.effect() instanceof Sleep);
        return isOfWoken ? words.of("cost.awake", price) : price;
    }

    private String refusal(Switching switching) {
        return switching.lack().map(this::refusal).orElse("");
    }

    private String refusal(Switching.Lack lack) {
        String or = words.of("effect.or");
        String needed = lack.needed().stream().map(this::title).collect(Collectors.joining(or));
        return words.of("effect.refusal", title(lack.needing()), needed);
    }

    private String title(String effect) {
        return words.of("effect." + effect);
    }

    private Optional<Chip> hot() {
        return chips.stream().filter(chip -> chip.holds(pointerX, pointerY)).findFirst();
    }

    /** Tells of its chips, if it was drawn, and says the words of the chip used last. */
    public void describe(Narrator narrator) {
        for (Chip chip : chips) {
            Plate place = new Plate(chip.x(), chip.y(), chip.width(), chip.height());
            Control.Kind kind = Control.Kind.of(isLit(chip));
            narrator.offers(place.control(chip.title(), kind, 0.5, false));
        }
        if (!refusal.isEmpty()) {
            narrator.says(refusal);
        }
    }

    /** Whether a point lies on the bar as it was last drawn. */
    public boolean contains(double px, double py) {
        return plate.contains(px, py);
    }

    /** Holds no point until it is drawn again. */
    public void hide() {
        plate = Plate.NONE;
        chips = List.of();
    }

    /** The pointer moved, px. */
    public void pointerMoved(double px, double py) {
        Optional<Chip> before = hot();
        pointerX = px;
        pointerY = py;
        if (!hot().equals(before)) {
            refusal = "";
        }
    }

    /** The pointer went down; returns whether on the bar. */
    public boolean pointerPressed(double px, double py) {
        pointerMoved(px, py);
        refusal = "";
        hot().ifPresent(chip -> flip(chip.effect()));
        return contains(px, py);
    }

    private void flip(Effect effect) {
        Switching switching = Switching.of(scene.pool().effects(), effect);
        Optional<Effects> next = switching.effects();
        next.ifPresent(scene::experiment);
        refusal = refusal(switching);
    }
}
