package rigibo.frontend.scene.ghost;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** The distance of two pools over the last ten seconds, on a logarithmic scale. */
public final class DistanceCurve {

    /** Powers of ten of a metre at the lower and the upper edge. */
    private static final int LOWEST = -13;

    private static final int HIGHEST = 1;

    private static final double SIZE = 16;

    /** Around the words of the scale, px. */
    private static final double ASIDE = 6;

    /** From one label to the next at least, in heights of their letters. */
    private static final double LINE = 1.25;

    private final double[] heights = new double[Divergence.KEPT];

    /** Draws the curve into a rectangle, px; it is filled from the left, then it moves. */
    public void draw(
            Canvas canvas, Divergence divergence, double x, double y, double width, double height) {
        canvas.panel(x, y, width, height, 8, Color.DUSK_TOP.alpha(0.8));
        double decade = height / (HIGHEST - LOWEST);
        double margin = margin(canvas);
        double letters = canvas.layout().textSize(SIZE);
        double half = letters / 2;
        int apart = 3;
        // The uppermost label may be lower than its line, so that it is not cut.
        while ((1 + apart) * decade - Math.max(decade, half) < LINE * letters) {
            apart += 3;
        }
        for (int power = 0; power > LOWEST; power -= apart) {
            double at = y + (HIGHEST - power) * decade;
            double middle = Math.max(y + half, Math.min(y + height - half, at));
            label(canvas, power, x, at, width, middle);
        }
        for (int i = 0; i < divergence.count(); i++) {
            heights[i] = heightOf(divergence.distance(i));
        }
        double span = (width - margin - ASIDE) * (divergence.count() - 1) / (Divergence.KEPT - 1);
        canvas.graph(heights, divergence.count(), x + margin, y, span, height, Color.BRASS);
    }

    /** Width of the scale's words, with room around them, px. */
    private static double margin(Canvas canvas) {
        return canvas.textWidth("1 mm", SIZE, Canvas.Font.NUMBERS) + 2 * ASIDE;
    }

    private static void label(
            Canvas canvas, int power, double x, double y, double width, double middle) {
        double left = x + margin(canvas);
        canvas.line(left, y, x + width - ASIDE, y, 1, Color.PANEL_LIT);
        String words =
                switch (power) {
                    case 0 -> "1 m";
                    case -3 -> "1 mm";
                    case -6 -> "1 µm";
                    case -9 -> "1 nm";
                    default -> "1 pm";
                };
        canvas.text(
                words,
                left - ASIDE,
                middle,
                SIZE,
                Canvas.Font.NUMBERS,
                Canvas.Align.RIGHT,
                Color.TEXT_DIM);
    }

    private static double heightOf(double metres) {
        double power = Math.log10(Math.max(metres, Double.MIN_NORMAL));
        // A hair above the edge, or the line of two equal worlds could not be seen.
        return Math.max(0.01, Math.min(0.99, (power - LOWEST) / (HIGHEST - LOWEST)));
    }
}
