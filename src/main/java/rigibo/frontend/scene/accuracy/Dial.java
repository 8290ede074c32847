package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Spread;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** The four presets side by side, with the same room around each name; that of the pool is lit. */
public final class Dial {

    /** px. */
    public static final double HEIGHT = 26;

    private static final List<String> NAMES =
            Arrays.stream(Preset.values()).map(Preset::name).toList();

    private static final double SIZE = 16;

    /** Mean width of a position with text of its usual size, px. */
    private static final double SEGMENT = 56;

    private static final double SEGMENT_IN_HAND = 72;

    private final Pool pool;
    private double x;
    private double y;

    private double height = HEIGHT;

    /** Where each position ends, px from the left; nowhere until it is drawn. */
    private double[] ends = new double[NAMES.size()];

    /** A dial of a pool. */
    public Dial(Pool pool) {
        this.pool = pool;
    }

    /** Its width, px. */
    static double width(Layout layout) {
        double segment = layout.isInHand() ? SEGMENT_IN_HAND : SEGMENT;
        return Preset.values().length * segment * layout.type();
    }

    /** Its height, px. */
    static double height(Layout layout) {
        return layout.clickable(HEIGHT);
    }

    /** Places and draws the dial with its upper left corner at a point, px. */
    public void draw(Canvas canvas, double left, double top) {
        x = left;
        y = top;
        double width = width(canvas.layout());
        height = height(canvas.layout());
        ends = Spread.ends(canvas, NAMES, SIZE, width);
        canvas.panel(x, y, width, height, 8, Color.PANEL_LIT);
        double from = 0;
        for (Preset preset : Preset.values()) {
            double end = ends[preset.ordinal()];
            draw(canvas, preset, x + from, end - from);
            from = end;
        }
    }

    private void draw(Canvas canvas, Preset preset, double from, double segment) {
        boolean isLit = pool.accuracy().equals(preset.accuracy());
        if (isLit) {
            canvas.panel(from, y, segment, height, 8, Color.BRASS);
        }
        canvas.text(
                preset.name(),
                from + segment / 2,
                y + height / 2,
                SIZE,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                isLit ? Color.DUSK_TOP : Color.TEXT_DIM);
    }

    /** Tells of its positions, if it was drawn. */
    void describe(Narrator narrator) {
        double from = 0;
        for (Preset preset : Preset.values()) {
            double end = ends[preset.ordinal()];
            if (end > from) {
                Plate place = new Plate(x + from, y, end - from, height);
                boolean isLit = pool.accuracy().equals(preset.accuracy());
                narrator.offers(place.control(preset.name(), Control.Kind.of(isLit), 0.5, false));
            }
            from = end;
        }
    }

    /** Has no position until it is drawn again. */
    void hide() {
        Arrays.fill(ends, 0);
    }

    /** The position under a point, px. */
    public Optional<Preset> at(double px, double py) {
        boolean isBeside = px < x || py < y || py >= y + height;
        return Arrays.stream(Preset.values())
                .filter(preset -> !isBeside && px < x + ends[preset.ordinal()])
                .findFirst();
    }

    /** Sets the pool's accuracy; its state stays as it is. Call between steps. */
    public void choose(Preset preset) {
        pool.accuracy(preset.accuracy());
    }
}
