package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;

/**
 * The energy of a scene: its parts, the loss by design, and the drift over the last 10 s. The
 * numbers are those of the pool, with potential energy relative to the world's origin; the bar
 * shows it relative to its lowest value, since a bar cannot show a negative length.
 */
public final class EnergyPlate {

    /** px. */
    public static final double HEIGHT = 232;

    private static final double MARGIN = 12;
    private static final double BAR_HEIGHT = 12;
    private static final double FIRST_ROW = 66;
    private static final double ROW = 22;
    private static final double GRAPH_TOP = 184;
    private static final double GRAPH_HEIGHT = 38;

    private final Pool pool;
    private final Words words;
    private final EnergyBook book = new EnergyBook();
    private final double[] curve = new double[EnergyBook.WINDOW];
    private double lowestPotential = Double.POSITIVE_INFINITY;

    /** A plate for a pool, in a player's words. */
    public EnergyPlate(Pool pool, Words words) {
        this.pool = pool;
        this.words = words;
    }

    /** Call before each step: sees whether the scene was edited. */
    public void beforeStep() {
        book.before(total());
    }

    /** Call after each step. */
    public void afterStep() {
        book.after(total());
    }

    private double total() {
        return pool.kineticEnergy() + pool.potentialEnergy();
    }

    /** Draws it with its upper left corner at (x, y), px. */
    public void draw(Canvas canvas, double x, double y, double width) {
        EnergyKind kind = EnergyKind.of(pool);
        Energy energy = Energy.of(pool);
        double left = x + MARGIN;
        double right = x + width - MARGIN;
        canvas.panel(x, y, width, HEIGHT, 12, Color.PANEL);
        words(canvas, words.of("energy.all"), left, y + 18, Color.TEXT);
        number(canvas, energy.total(), right, y + 18, Color.TEXT);
        bar(canvas, energy, book.lost(kind), left, y + 40, right - left);
        row(
                canvas,
                words.of("energy.potential"),
                energy.potential(),
                Color.ICE,
                left,
                right,
                y + FIRST_ROW);
        double second = y + FIRST_ROW + ROW;
        row(
                canvas,
                words.of("energy.translational"),
                energy.translational(),
                Color.RIGIBO,
                left,
                right,
                second);
        row(
                canvas,
                words.of("energy.rotational"),
                energy.rotational(),
                Color.GOOD,
                left,
                right,
                second + ROW);
        double account = second + 2 * ROW;
        switch (kind) {
            case CONSERVED ->
                    row(canvas, words.of("energy.lost"), 0, Color.RUBBER, left, right, account);
            case LOSING -> {
                // Nobody can tell a loss from drift downwards, and the words say so.
                String name = words.of("energy.losing");
                row(canvas, name, book.lost(kind), Color.RUBBER, left, right, account);
            }
            case WORKED -> words(canvas, words.of("energy.worked"), left, account, Color.TEXT);
        }
        boolean isWorked = kind == EnergyKind.WORKED;
        double change = isWorked ? book.work(kind) : book.drift(kind);
        String name =
                isWorked
                        ? words.of("energy.change")
                        : kind == EnergyKind.LOSING
                                ? words.of("energy.rise")
                                : words.of("energy.drift");
        words(canvas, name, left, account + ROW, Color.BRASS);
        number(canvas, change, right, account + ROW, Color.BRASS);
        graph(canvas, kind, left, y + GRAPH_TOP, right - left);
    }

    private void bar(Canvas canvas, Energy energy, double lost, double x, double y, double width) {
        lowestPotential = Math.min(lowestPotential, energy.potential());
        double[] parts = {
            energy.potential() - lowestPotential, energy.translational(), energy.rotational(), lost
        };
        Color[] colors = {Color.ICE, Color.RIGIBO, Color.GOOD, Color.RUBBER};
        double sum = parts[0] + parts[1] + parts[2] + parts[3];
        canvas.panel(x, y, width, BAR_HEIGHT, 4, Color.PANEL_LIT);
        double from = x;
        for (int i = 0; i < parts.length && sum > 0; i++) {
            double length = width * parts[i] / sum;
            canvas.panel(from, y, length, BAR_HEIGHT, Math.min(4, length / 2), colors[i]);
            from += length;
        }
    }

    /** Up and down from the middle, as far as the greatest of these changes. */
    private void graph(Canvas canvas, EnergyKind kind, double x, double y, double width) {
        canvas.panel(x, y, width, GRAPH_HEIGHT, 6, Color.PANEL_LIT);
        double middle = y + GRAPH_HEIGHT / 2;
        canvas.line(x, middle, x + width, middle, 1, Color.EDGE);
        int count = book.curve(kind, curve);
        double most = Double.MIN_NORMAL;
        for (int i = 0; i < count; i++) {
            most = Math.max(most, Math.abs(curve[i]));
        }
        for (int i = 0; i < count; i++) {
            curve[i] = 0.5 + 0.5 * curve[i] / most;
        }
        double length = width * count / EnergyBook.WINDOW;
        double from = x + width - length;
        canvas.graph(curve, count, from, y + 2, length, GRAPH_HEIGHT - 4, Color.BRASS);
    }

    private void row(
            Canvas canvas,
            String words,
            double joules,
            Color color,
            double left,
            double right,
            double y) {
        canvas.disc(left + 6, y, 6, color);
        words(canvas, words, left + 20, y, Color.TEXT);
        number(canvas, joules, right, y, Color.TEXT);
    }

    private static void words(Canvas canvas, String words, double x, double y, Color color) {
        canvas.text(words, x, y, 16, Canvas.Font.WORDS, Canvas.Align.LEFT, color);
    }

    private void number(Canvas canvas, double joules, double right, double y, Color color) {
        canvas.text(
                Joules.words(words, joules),
                right,
                y,
                16,
                Canvas.Font.NUMBERS,
                Canvas.Align.RIGHT,
                color);
    }
}
