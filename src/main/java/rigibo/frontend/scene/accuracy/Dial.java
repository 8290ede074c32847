package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.Optional;

/** The four presets side by side; that of the pool is lit. */
public final class Dial {

    /** px. */
    public static final double HEIGHT = 26;

    private static final double SEGMENT = 56;

    /** px. */
    public static final double WIDTH = Preset.values().length * SEGMENT;

    private final Pool pool;
    private final double x;
    private final double y;

    /** A dial of a pool with its upper left corner at (x, y), px. */
    public Dial(Pool pool, double x, double y) {
        this.pool = pool;
        this.x = x;
        this.y = y;
    }

    /** Draws it. */
    public void draw(Canvas canvas) {
        canvas.panel(x, y, WIDTH, HEIGHT, 8, Color.PANEL_LIT);
        for (Preset preset : Preset.values()) {
            boolean isLit = pool.accuracy().equals(preset.accuracy());
            double left = x + preset.ordinal() * SEGMENT;
            if (isLit) {
                canvas.panel(left, y, SEGMENT, HEIGHT, 8, Color.BRASS);
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

    /** The position under a point, px. */
    public Optional<Preset> at(double px, double py) {
        boolean isInside = px >= x && px < x + WIDTH && py >= y && py < y + HEIGHT;
        return isInside
                ? Optional.of(Preset.values()[(int) ((px - x) / SEGMENT)])
                : Optional.empty();
    }

    /** Sets the pool's accuracy; its state stays as it is. Call between steps. */
    public void choose(Preset preset) {
        pool.accuracy(preset.accuracy());
    }
}
