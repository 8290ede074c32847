package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** A tick and a cross for good and bad, which do not rely on colour alone. */
public final class Sign {

    /** From the middle to the foot of a tick, a share of its arm. */
    private static final double FOOT = 0.28;

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
}
