package rigibo.frontend.scene.effects;

import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * The effects of a scene as chips, lit when simulated. The pointer over a chip shows what the
 * effect does in the scene and what it costs; a click switches it, which is marked as an
 * experiment.
 */
public final class EffectsBar {

    private static final double LEFT = 8;
    private static final double WIDTH = Scene.WIDTH - 2 * LEFT;
    private static final double PADDING = 10;
    private static final double ROWS =
            ChipLayout.ROWS * Chip.HEIGHT + (ChipLayout.ROWS - 1) * ChipLayout.GAP;

    /** A line of words, px. */
    private static final double LINE = 22;

    private static final double INDENT = LEFT + PADDING + 4;

    /** px. */
    public static final double HEIGHT = PADDING + ROWS + 6 + 2 * LINE + 6;

    private final SceneEffects scene;
    private final Words words;
    private final CostWords said;
    private final CostMeter meter;
    private List<Chip> chips = List.of();
    private double top;
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

    /** Draws the bar with its upper edge at y, px. */
    public void draw(Canvas canvas, double y) {
        top = y;
        chips =
                ChipLayout.of(scene, canvas, WIDTH - 2 * PADDING).stream()
                        .map(chip -> chip.movedBy(LEFT + PADDING, top + PADDING))
                        .toList();
        boolean isExperiment = !scene.marking().isEmpty();
        canvas.panel(LEFT, top, WIDTH, HEIGHT, 12, Color.PANEL);
        if (isExperiment) {
            canvas.frame(LEFT, top, WIDTH, HEIGHT, 12, Color.BAD);
        }
        Effects calledFor = scene.calledFor();
        chips.forEach(chip -> draw(canvas, chip, calledFor));
        double line = top + PADDING + ROWS + 6 + LINE / 2;
        words(canvas, what(), line, refusal.isEmpty() ? Color.TEXT : Color.BAD);
        words(canvas, cost(), line + LINE, Color.BRASS);
        if (isExperiment && hot().isPresent()) {
            drawMark(canvas, line + LINE);
        }
    }

    private void draw(Canvas canvas, Chip chip, Effects calledFor) {
        Estimate cost = meter.cost(chip.effect());
        // What sleeps costs nothing, and its share when awake is of another step than the game's.
        boolean isOfStep = cost.isKnown() && meter.step() > 0 && !meter.hasWoken();
        double share = isOfStep ? cost.mean() / meter.step() : 0;
        boolean isCalledFor = calledFor.declares(chip.effect().getClass());
        chip.draw(canvas, isLit(chip), isLit(chip) != isCalledFor, share);
    }

    /** While a chip is explained, the experiment stays marked in a corner. */
    private void drawMark(Canvas canvas, double y) {
        canvas.text(
                words.of("effect.experiment"),
                LEFT + WIDTH - PADDING - 4,
                y,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.RIGHT,
                Color.BAD);
    }

    private static void words(Canvas canvas, String words, double y, Color color) {
        canvas.text(words, INDENT, y, 16, Canvas.Font.WORDS, Canvas.Align.LEFT, color);
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

    /** Whether a point lies on the bar as it was last drawn. */
    public boolean contains(double px, double py) {
        return px >= LEFT && px <= LEFT + WIDTH && py >= top && py <= top + HEIGHT;
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
