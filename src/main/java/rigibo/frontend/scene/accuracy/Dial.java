package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.Optional;

/** The four presets side by side; that of the pool is lit. */
public final class Dial {

    /** px. */
    public static final double HEIGHT = 26;

    /** Width of a position with text of its usual size, px. */
    private static final double SEGMENT = 56;

    private static final int NONE = -1;

    private final Pool pool;
    private double x;
    private double y;
    private double segment;

    /** A dial of a pool. */
    public Dial(Pool pool) {
        this.pool = pool;
    }

    /** Its width with text enlarged by a factor, px. */
    static double width(double type) {
        return Preset.values().length * SEGMENT * type;
    }

    /** Draws it with its upper left corner at a point, px; there it is from then on. */
    public void draw(Canvas canvas, double left, double top) {
        x = left;
        y = top;
        segment = SEGMENT * canvas.layout().type();
        canvas.panel(x, y, Preset.values().length * segment, HEIGHT, 8, Color.PANEL_LIT);
        for (Preset preset : Preset.values()) {
            draw(canvas, preset, x + preset.ordinal() * segment);
        }
    }

    private void draw(Canvas canvas, Preset preset, double from) {
        boolean isLit = pool.accuracy().equals(preset.accuracy());
        if (isLit) {
            canvas.panel(from, y, segment, HEIGHT, 8, Color.BRASS);
        }
        canvas.text(
                preset.name(),
                from + segment / 2,
                y + HEIGHT / 2,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                isLit ? Color.DUSK_TOP : Color.TEXT_DIM);
    }

    /** Has no position until it is drawn again. */
    void hide() {
        segment = 0;
    }

    /** The position under a point, px. */
    public Optional<Preset> at(double px, double py) {
        int position = segment > 0 ? (int) Math.floor((px - x) / segment) : NONE;
        boolean isInside =
                position >= 0 && position < Preset.values().length && py >= y && py < y + HEIGHT;
        return isInside ? Optional.of(Preset.values()[position]) : Optional.empty();
    }

    /** Sets the pool's accuracy; its state stays as it is. Call between steps. */
    public void choose(Preset preset) {
        pool.accuracy(preset.accuracy());
    }
}
