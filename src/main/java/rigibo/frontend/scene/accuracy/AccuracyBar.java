package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The dial with the cost and the accuracy of its present position: the time of a step, its price in
 * steps at DRAFT, the error, and whether the scene keeps up with real time. The pointer over a
 * position or the badge shows an explanation.
 */
public final class AccuracyBar {

    private static final double PADDING = 5;

    /** A line of words, px. */
    private static final double LINE = 22;

    private static final double SIZE = 16;

    /** Gap between the dial and the words beside it, px. */
    private static final double GAP = 9;

    /** Least room beside the dial for words; with less they stand below it, px. */
    private static final double LEAST_ROOM = 200;

    /** Lines of words below the dial. */
    private static final int LINES_BELOW = 3;

    private static final String BETWEEN = " · ";

    private final Pool pool;
    private final AccuracyMeter meter;
    private final Words words;
    private final Badge badge;
    private final Dial dial;
    private final StepTimes times = new StepTimes();
    private Plate plate = Plate.NONE;

    /** Where the words are. */
    private Plate room = Plate.NONE;

    private double pointerX = -1;
    private double pointerY = -1;
    private double pace = 1;

    /** A bar of a pool, with prices and errors from a meter, in words. */
    public AccuracyBar(Pool pool, AccuracyMeter meter, Words words) {
        this.pool = pool;
        this.words = words;
        badge = new Badge(words);
        this.meter = meter;
        dial = new Dial(pool);
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

    /** Its height where it is so wide, px. */
    public static double height(Layout layout, double width) {
        double beside = width - 2 * PADDING - Dial.width(layout) - GAP;
        if (beside < LEAST_ROOM) {
            return 3 * PADDING + Dial.height(layout) + LINES_BELOW * LINE;
        }
        return 2 * PADDING + Math.max(Dial.height(layout), linesBeside(layout) * LINE);
    }

    /** Where text is enlarged, one line beside the dial does not hold the numbers. */
    private static int linesBeside(Layout layout) {
        return layout.type() > 1 ? 2 : 1;
    }

    /** Draws it from an upper left corner, px, so wide. */
    public void draw(Canvas canvas, double x, double y, double width, boolean isPaused) {
        place(canvas.layout(), x, y, width);
        canvas.panel(x, y, width, plate.height(), 12, Color.PANEL);
        dial.draw(canvas, x + PADDING, y + PADDING);
        boolean isLate = Badge.isLate(pace) && !isPaused;
        List<String> lines = lines(canvas, isPaused);
        double middle = room.y() + (room.height() - (lines.size() - 1) * LINE) / 2;
        for (String line : lines) {
            Print.left(canvas, line, room.x(), middle, SIZE, isLate ? Color.RIGIBO : Color.TEXT);
            middle += LINE;
        }
    }

    private void place(Layout layout, double x, double y, double width) {
        plate = new Plate(x, y, width, height(layout, width));
        double dialled = PADDING + Dial.width(layout) + GAP;
        boolean isBelow = width - dialled - PADDING < LEAST_ROOM;
        double inset = 2 * PADDING;
        double below = 2 * PADDING + Dial.height(layout);
        room =
                isBelow
                        ? new Plate(x + inset, y + below, width - 2 * inset, LINES_BELOW * LINE)
                        : new Plate(x + dialled, y, width - dialled - PADDING, plate.height());
    }

    private List<String> lines(Canvas canvas, boolean isPaused) {
        Optional<String> help =
                dial.at(pointerX, pointerY)
                        .map(preset -> preset.help(words))
                        .or(() -> Optional.of(help()).filter(any -> isHelping()));
        return help.map(said -> Lines.of(canvas, said, SIZE, Canvas.Font.WORDS, room.width()))
                .orElseGet(() -> joined(canvas, numbers(isPaused)));
    }

    /** Numbers in lines, broken between two of them. */
    private List<String> joined(Canvas canvas, List<String> numbers) {
        List<String> lines = new ArrayList<>();
        String line = "";
        for (String number : numbers) {
            String longer = line.isEmpty() ? number : line + BETWEEN + number;
            boolean fits =
                    canvas.textWidth(longer, SIZE, Canvas.Font.WORDS) <= room.width()
                            || line.isEmpty();
            if (!fits) {
                lines.add(line);
            }
            line = fits ? longer : number;
        }
        lines.add(line);
        return lines;
    }

    private boolean isHelping() {
        return room.contains(pointerX, pointerY);
    }

    /** How long the copies ran; shorter where the scene is so slow that they were cut short. */
    private String help() {
        boolean isWhole = meter.last().map(AccuracyTrial.Result::isWhole).orElse(true);
        int steps = meter.last().map(AccuracyTrial.Result::steps).orElse(AccuracyTrial.STEPS);
        String after = isWhole ? words.of("badge.half-second") : words.of("badge.steps", steps);
        return words.of("badge.help", after);
    }

    /** The numbers that belong to the lit position. */
    private List<String> numbers(boolean isPaused) {
        return List.of(
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

    /** Tells of the positions of its dial, if it was drawn. */
    public void describe(Narrator narrator) {
        dial.describe(narrator);
    }

    /** Whether a point lies on the bar as it was last drawn. */
    public boolean contains(double px, double py) {
        return plate.contains(px, py);
    }

    /** Holds no point until it is drawn again. */
    public void hide() {
        plate = Plate.NONE;
        room = Plate.NONE;
        dial.hide();
    }

    /** The pointer moved, px. */
    public void pointerMoved(double px, double py) {
        pointerX = px;
        pointerY = py;
    }

    /** The pointer went down. */
    public void pointerPressed(double px, double py) {
        pointerMoved(px, py);
        dial.at(px, py).ifPresent(this::choose);
    }

    /** Turns the dial; the scene goes on from its present state. */
    public void choose(Preset preset) {
        dial.choose(preset);
        times.forget();
    }
}
