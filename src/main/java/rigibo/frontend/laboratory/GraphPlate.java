package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.ghost.DistanceCurve;
import rigibo.frontend.scene.ghost.Divergence;
import rigibo.frontend.scene.ghost.Metres;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;

import java.util.List;
import java.util.Optional;

/** A quantity of both worlds, now and over the last ten seconds, with a note below. */
final class GraphPlate {

    private static final double PADDING = 12;
    private static final double LINE = 24;
    private static final double SIZE = 16;

    /** Least width for the numbers of the scale, and the margin around them, px. */
    private static final double MARGIN = 104;

    private static final double ASIDE = 8;

    /** Steps that are shown: 10 s. */
    private static final int SHOWN = 600;

    /** Below it four decimals say too little. */
    private static final double TINY = 1e-3;

    /** Marks of the two worlds: they differ in shape as well. */
    static final Color LEFT = Color.BRASS;

    static final Color RIGHT = Color.ICE;

    private final DistanceCurve curve = new DistanceCurve();
    private final double[] heights = new double[SHOWN];
    private final Words words;
    private Plate plate = Plate.NONE;

    GraphPlate(Words words) {
        this.words = words;
    }

    /** Moves it, px. */
    void place(Plate at) {
        plate = at;
    }

    /** Draws the distance of the worlds, on a logarithmic scale, and news or else a question. */
    void drawDistance(
            Canvas canvas, Divergence divergence, Optional<String> news, String question) {
        head(canvas, Quantity.DISTANCE, "laboratory.distance");
        number(canvas, Metres.words(words, divergence.distance()), right());
        Plate graph = note(canvas, news.orElse(question), news.isPresent());
        curve.draw(canvas, divergence, graph.x(), graph.y(), graph.width(), graph.height());
    }

    /** Draws a quantity of each world. */
    void draw(Canvas canvas, Log log, Quantity quantity, String note) {
        head(canvas, quantity, quantity.key() + ".long");
        if (log.count() > 0) {
            double at = mark(canvas, log, quantity, Log.Side.RIGHT, right());
            mark(canvas, log, quantity, Log.Side.LEFT, at - PADDING);
        }
        Plate graph = note(canvas, note, false);
        canvas.panel(
                graph.x(), graph.y(), graph.width(), graph.height(), 8, Color.DUSK_TOP.alpha(0.8));
        if (log.count() > 1) {
            curves(canvas, log, quantity, graph);
        }
    }

    /** The mark of a world, and its present value; returns the left edge. */
    private double mark(Canvas canvas, Log log, Quantity quantity, Log.Side side, double right) {
        double value = log.value(quantity, side, log.count() - 1);
        String told = number(value) + (quantity.unit.isEmpty() ? "" : " " + quantity.unit);
        number(canvas, told, right);
        double left = right - canvas.textWidth(told, SIZE, Canvas.Font.NUMBERS) - 16;
        double middle = plate.y() + 4 + LINE / 2;
        if (side == Log.Side.LEFT) {
            canvas.disc(left + 4, middle, 6, LEFT);
        } else {
            canvas.panel(left - 2, middle - 6, 12, 12, 1, RIGHT);
        }
        return left - PADDING;
    }

    private void curves(Canvas canvas, Log log, Quantity quantity, Plate graph) {
        int count = Math.min(SHOWN, log.count());
        int first = log.count() - count;
        double least = quantity.beginsAtZero() ? 0 : Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (Log.Side side : Log.Side.values()) {
            for (int i = 0; i < count; i++) {
                least = Math.min(least, log.value(quantity, side, first + i));
                most = Math.max(most, log.value(quantity, side, first + i));
            }
        }
        double room = Math.max(most - least, Double.MIN_NORMAL);
        double margin = Math.max(margin(canvas, number(most)), margin(canvas, number(least)));
        scale(canvas, number(most), graph.x() + margin, graph.y() + LINE / 2);
        scale(canvas, number(least), graph.x() + margin, graph.bottom() - LINE / 2);
        double span = (graph.width() - margin - 6) * (count - 1) / (SHOWN - 1);
        for (Log.Side side : Log.Side.values()) {
            for (int i = 0; i < count; i++) {
                double share = (log.value(quantity, side, first + i) - least) / room;
                // A hair from the edges, or a flat line could not be seen.
                heights[i] = 0.02 + 0.96 * share;
            }
            Color ink = side == Log.Side.LEFT ? LEFT : RIGHT;
            canvas.graph(heights, count, graph.x() + margin, graph.y(), span, graph.height(), ink);
        }
    }

    private static double margin(Canvas canvas, String told) {
        return Math.max(MARGIN, canvas.textWidth(told, SIZE, Canvas.Font.NUMBERS) + 2 * ASIDE);
    }

    private static void scale(Canvas canvas, String told, double right, double y) {
        canvas.text(
                told,
                right - ASIDE,
                y,
                SIZE,
                Canvas.Font.NUMBERS,
                Canvas.Align.RIGHT,
                Color.TEXT_DIM);
    }

    /** Formats a number without meaningless digits; a tiny one is given by its power of ten. */
    private String number(double value) {
        if (value != 0 && Math.abs(value) < TINY) {
            return words.number("%.1e", value);
        }
        String digits = words.number("%.4f", value);
        return digits.replaceFirst("[.,]?0+$", "").replaceFirst("^-0$", "0");
    }

    private double left() {
        return plate.x() + PADDING;
    }

    private double right() {
        return plate.right() - PADDING;
    }

    /** Draws the plate and its title, which is short in a handheld window. */
    private void head(Canvas canvas, Quantity quantity, String key) {
        canvas.panel(plate.x(), plate.y(), plate.width(), plate.height(), 12, Color.PANEL);
        String title = words.of(canvas.layout().isInHand() ? quantity.key() : key);
        text(canvas, title, plate.y() + 4 + LINE / 2, Color.TEXT_DIM);
    }

    private void number(Canvas canvas, String told, double x) {
        double y = plate.y() + 4 + LINE / 2;
        canvas.text(told, x, y, SIZE, Canvas.Font.NUMBERS, Canvas.Align.RIGHT, Color.TEXT);
    }

    /** Draws the note at the foot; returns the remaining place for the graph. */
    private Plate note(Canvas canvas, String note, boolean isLit) {
        double width = plate.width() - 2 * PADDING;
        List<String> lines = Lines.of(canvas, note, SIZE, Canvas.Font.WORDS, width);
        double foot = lines.size() * LINE;
        double y = plate.bottom() - 3 - foot + LINE / 2;
        for (String line : lines) {
            text(canvas, line, y, isLit ? Color.BRASS : Color.TEXT);
            y += LINE;
        }
        return new Plate(left(), plate.y() + 4 + LINE, width, plate.height() - LINE - foot - 10);
    }

    private void text(Canvas canvas, String told, double y, Color ink) {
        canvas.text(told, left(), y, SIZE, Canvas.Font.WORDS, Canvas.Align.LEFT, ink);
    }
}
