package rigibo.frontend.demo;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** The four presets side by side; the one that the pool runs at is lit. */
final class AccuracyDial {

    static final double HEIGHT = 40;

    private static final double WIDTH = StageProfile.WIDTH;
    private static final double PADDING = 5;

    /** The presets from the fastest to the most accurate. */
    enum Preset {
        DRAFT(Accuracy.DRAFT),
        GAME(Accuracy.GAME),
        FINE(Accuracy.FINE),
        EXACT(Accuracy.EXACT);

        private final Accuracy accuracy;

        Preset(Accuracy accuracy) {
            this.accuracy = accuracy;
        }
    }

    private static final double SEGMENT = (WIDTH - 2 * PADDING) / Preset.values().length;

    private final Pool pool;
    private final double x;
    private final double y;

    /** A dial of a pool with its upper left corner at (x, y), px. */
    AccuracyDial(Pool pool, double x, double y) {
        this.pool = pool;
        this.x = x;
        this.y = y;
    }

    void draw(Canvas canvas) {
        canvas.panel(x, y, WIDTH, HEIGHT, 12, Color.PANEL);
        for (Preset preset : Preset.values()) {
            boolean isLit = pool.accuracy().equals(preset.accuracy);
            double left = x + PADDING + preset.ordinal() * SEGMENT;
            if (isLit) {
                canvas.panel(left, y + PADDING, SEGMENT, HEIGHT - 2 * PADDING, 8, Color.BRASS);
            }
            canvas.text(
                    preset.name(),
                    left + SEGMENT / 2,
                    y + HEIGHT / 2,
                    16,
                    Canvas.Font.WORDS,
                    Canvas.Align.CENTRE,
                    isLit ? Color.DUSK_TOP : Color.TEXT_DIM);
        }
    }

    /** The pointer went down; returns whether on the dial. */
    boolean pointerPressed(double px, double py) {
        boolean isInside = px >= x && px <= x + WIDTH && py >= y && py <= y + HEIGHT;
        if (isInside) {
            int last = Preset.values().length - 1;
            choose(Math.max(0, Math.min(last, (int) ((px - x - PADDING) / SEGMENT))));
        }
        return isInside;
    }

    /** Chooses a preset, 0 the fastest. */
    void choose(int preset) {
        pool.accuracy(Preset.values()[preset].accuracy);
    }
}
