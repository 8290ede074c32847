package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** A tick and a cross for good and bad, and a star: signs that do not rely on colour alone. */
public final class Sign {

    /** From the middle to the foot of a tick, a share of its arm. */
    private static final double FOOT = 0.28;

    /** Points of a star's outline, alternately tips and notches; the first one comes twice. */
    private static final int STAR_POINTS = 11;

    /** From the middle to a notch of a star, a share of the way to a tip. */
    private static final double NOTCH = 0.5;

    private Sign() {}

    /**
     * A tick about a point.
     *
     * @param arm from there to either side, px
     * @param width of its lines, px
     */
    public static void tick(
            Canvas canvas, double x, double y, double arm, double width, Color color) {
        double foot = x - Math.round(FOOT * arm);
        double rise = arm - 1;
        canvas.line(x - arm, y, foot, y + rise, width, color);
        canvas.line(foot, y + rise, x + arm, y - rise, width, color);
    }

    /**
     * A cross about a point.
     *
     * @param arm from there to every side, px
     * @param width of its lines, px
     */
    public static void cross(
            Canvas canvas, double x, double y, double arm, double width, Color color) {
        canvas.line(x - arm, y - arm, x + arm, y + arm, width, color);
        canvas.line(x - arm, y + arm, x + arm, y - arm, width, color);
    }

    /**
     * The outline of a star with five tips.
     *
     * @param radius from its middle to a tip, px
     * @param width of its lines, px
     */
    public static void outlinedStar(
            Canvas canvas, double x, double y, double radius, double width, Color color) {
        double[] xy = new double[2 * STAR_POINTS];
        for (int i = 0; i < STAR_POINTS; i++) {
            double reach = i % 2 == 0 ? radius : NOTCH * radius;
            double angle = 2 * Math.PI * i / (STAR_POINTS - 1);
            xy[2 * i] = x + reach * Math.sin(angle);
            xy[2 * i + 1] = y - reach * Math.cos(angle);
        }
        canvas.curve(xy, STAR_POINTS, width, color);
    }

    /**
     * A star of brass with five tips, filled by outlines that lie on each other.
     *
     * @param radius from its middle to a tip, px
     */
    public static void star(Canvas canvas, double x, double y, double radius) {
        double width = 0.22 * radius;
        for (double rest = radius - width / 2; rest > 0; rest -= 0.8 * width) {
            outlinedStar(canvas, x, y, rest, width, Color.BRASS);
        }
    }
}
