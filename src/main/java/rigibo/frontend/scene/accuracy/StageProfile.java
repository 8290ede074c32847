package rigibo.frontend.scene.accuracy;

import rigibo.backend.StepReport;
import rigibo.backend.setup.StepStage;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;

/**
 * The time of a frame by stages of a step and drawing, smoothed and stacked, against the 16.7 ms
 * that a frame may take.
 */
public final class StageProfile {

    /** Longest time of a step and its drawing together, ms. */
    public static final double BUDGET_MILLIS = 1000.0 / 60;

    /** px. */
    public static final double HEIGHT = 178;

    private static final double PADDING = 12;

    /** Number of frames over which times are smoothed. */
    private static final double SMOOTHING = 15;

    /** The parts that are shown. The last one is drawing, which is no stage of a step. */
    private enum Part {
        BROADPHASE("profile.broadphase", Color.ICE),
        COLLISION("profile.collision", Color.RIGIBO),
        SOLVER("profile.solver", Color.RUBBER),
        FLIGHT("profile.flight", Color.GOOD),
        DRAWING("profile.drawing", Color.TEXT_DIM);

        private final String key;
        private final Color color;

        Part(String key, Color color) {
            this.key = key;
            this.color = color;
        }

        private static Part of(StepStage stage) {
            return switch (stage) {
                case ACCEPT, EFFECTS, BROADPHASE -> BROADPHASE;
                case CLASSIFY -> COLLISION;
                case FLIGHT -> FLIGHT;
                case CONTACT, REST, REPORT -> SOLVER;
            };
        }
    }

    private final Words words;
    private final double[] millis = new double[Part.values().length];

    /** A profile in a player's words. */
    public StageProfile(Words words) {
        this.words = words;
    }

    /** Records the times of a step. */
    public void step(StepReport report) {
        double[] now = new double[millis.length];
        for (StepStage stage : StepStage.values()) {
            now[Part.of(stage).ordinal()] += report.nanos(stage) / 1e6;
        }
        for (int i = 0; i < Part.DRAWING.ordinal(); i++) {
            millis[i] += (now[i] - millis[i]) / SMOOTHING;
        }
    }

    /** Records the time that drawing took, ns. */
    public void drawing(long nanos) {
        int i = Part.DRAWING.ordinal();
        millis[i] += (nanos / 1e6 - millis[i]) / SMOOTHING;
    }

    /** Draws the plate with its upper left corner at (x, y), px, so wide. */
    public void draw(Canvas canvas, double x, double y, double width) {
        canvas.panel(x, y, width, HEIGHT, 12, Color.PANEL);
        double total = 0;
        for (double part : millis) {
            total += part;
        }
        words(canvas, words.of("profile.all"), x + PADDING, y + 18);
        double right = x + width - PADDING;
        number(canvas, total, right, y + 18);
        bar(canvas, x + PADDING, y + 34, right - x - PADDING, total);
        for (Part part : Part.values()) {
            double middle = y + 68 + 22 * part.ordinal();
            canvas.disc(x + 20, middle, 6, part.color);
            words(canvas, words.of(part.key), x + 34, middle);
            number(canvas, millis[part.ordinal()], right, middle);
        }
    }

    /** Draws the parts side by side; a frame over the budget gets a red border. */
    private void bar(Canvas canvas, double x, double y, double length, double total) {
        canvas.panel(x, y, length, 12, 4, Color.PANEL_LIT);
        double scale = length / Math.max(BUDGET_MILLIS, total);
        double from = x;
        for (Part part : Part.values()) {
            double width = millis[part.ordinal()] * scale;
            canvas.panel(from, y, width, 12, Math.min(4, width / 2), part.color);
            from += width;
        }
        if (total > BUDGET_MILLIS) {
            canvas.frame(x - 2, y - 2, length + 4, 16, 5, Color.BAD);
        }
        double line = x + BUDGET_MILLIS * scale;
        canvas.line(line, y - 4, line, y + 16, 2, Color.BRASS);
    }

    private static void words(Canvas canvas, String words, double x, double y) {
        canvas.text(words, x, y, 16, Canvas.Font.WORDS, Canvas.Align.LEFT, Color.TEXT);
    }

    private void number(Canvas canvas, double millis, double x, double y) {
        canvas.text(
                words.number("%.2f ms", millis),
                x,
                y,
                16,
                Canvas.Font.NUMBERS,
                Canvas.Align.RIGHT,
                Color.TEXT);
    }
}
