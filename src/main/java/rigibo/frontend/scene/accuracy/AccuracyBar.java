package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;

import java.util.Optional;

/**
 * The dial with the cost and the accuracy of its present position: the time of a step, its price in
 * steps at DRAFT, the error, and whether the scene keeps up with real time. The pointer over a
 * position or the badge shows an explanation.
 */
public final class AccuracyBar {

    /** px. */
    public static final double HEIGHT = 36;

    private static final double LEFT = 8;
    private static final double WIDTH = Scene.WIDTH - 2 * LEFT;
    private static final double PADDING = (HEIGHT - Dial.HEIGHT) / 2;
    private static final double WORDS_LEFT = LEFT + PADDING + Dial.WIDTH + 9;

    private final Pool pool;
    private final AccuracyMeter meter;
    private final Words words;
    private final Badge badge;
    private final Dial dial;
    private final StepTimes times = new StepTimes();
    private final double top;
    private double pointerX = -1;
    private double pointerY = -1;
    private double pace = 1;

    /**
     * A bar of a pool with its upper edge at y, px, with prices and errors from a meter, in words.
     */
    public AccuracyBar(Pool pool, AccuracyMeter meter, Words words, double y) {
        this.pool = pool;
        this.words = words;
        badge = new Badge(words);
        this.meter = meter;
        top = y;
        dial = new Dial(pool, LEFT + PADDING, top + PADDING);
    }

    /** Call after each step. */
    public void stepped() {
        times.add(pool.report());
    }

    /** Call when a frame was drawn: goes on measuring. */
    public void turn() {
        meter.turn(pool);
    }

    /** Takes the share of real time that the world runs at, 0 to 1. */
    public void paced(double share) {
        pace = share;
    }

    /** Draws it. */
    public void draw(Canvas canvas, boolean isPaused) {
        canvas.panel(LEFT, top, WIDTH, HEIGHT, 12, Color.PANEL);
        dial.draw(canvas);
        Optional<Preset> hot = dial.at(pointerX, pointerY);
        String said =
                hot.map(preset -> preset.help(words))
                        .orElse(isHelping() ? help() : numbers(isPaused));
        boolean isLate = Badge.isLate(pace) && !isPaused;
        canvas.text(
                said,
                WORDS_LEFT,
                top + HEIGHT / 2,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.LEFT,
                isLate ? Color.RIGIBO : Color.TEXT);
    }

    private boolean isHelping() {
        return contains(pointerX, pointerY) && pointerX >= WORDS_LEFT;
    }

    /** How long the copies ran; shorter where the scene is so slow that they were cut short. */
    private String help() {
        boolean isWhole = meter.last().map(AccuracyTrial.Result::isWhole).orElse(true);
        int steps = meter.last().map(AccuracyTrial.Result::steps).orElse(AccuracyTrial.STEPS);
        String after = isWhole ? words.of("badge.half-second") : words.of("badge.steps", steps);
        return words.of("badge.help", after);
    }

    /** The numbers that belong to the lit position. */
    private String numbers(boolean isPaused) {
        return String.join(
                " · ",
                badge.step(times.median()),
                meter.last().map(last -> badge.price(meter.price())).orElse(badge.unknownPrice()),
                error(),
                isPaused ? words.of("badge.paused") : badge.pace(Badge.isLate(pace) ? pace : 1));
    }

    /** EXACT has no error to itself, which does not mean that it has none. */
    private String error() {
        return pool.accuracy().equals(Accuracy.EXACT)
                ? words.of("badge.reference")
                : meter.last().map(last -> badge.error(last.error())).orElse(badge.unknownError());
    }

    /** Whether a point lies on the bar. */
    public boolean contains(double px, double py) {
        return px >= LEFT && px <= LEFT + WIDTH && py >= top && py <= top + HEIGHT;
    }

    /** The pointer moved, px. */
    public void pointerMoved(double px, double py) {
        pointerX = px;
        pointerY = py;
    }

    /** The pointer went down; returns whether on the bar. */
    public boolean pointerPressed(double px, double py) {
        pointerMoved(px, py);
        dial.at(px, py).ifPresent(this::choose);
        return contains(px, py);
    }

    /** Turns the dial; the scene goes on from where it is. */
    public void choose(Preset preset) {
        dial.choose(preset);
        times.forget();
    }
}
