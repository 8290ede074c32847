package rigibo.frontend.editor.pane;

import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** The icons of the tools for joints, 22 px. */
final class JointIcon {

    private static final double STROKE = 2.5;
    private static final double END = 3.5;

    /** A cord that hangs through between its ends. */
    private static final double[] SAG = {-9, -7, -7, 1, -4, 6, 0, 8, 4, 6, 7, 1, 9, -7};

    private static final double[] COIL = {-11, 0, -8, 0, -6, -6, -2, 6, 2, -6, 6, 6, 8, 0, 11, 0};
    private static final double[] STRUT = {-6, -12, 6, -12, -5, -8, 5, -5, 0, -2};

    private JointIcon() {}

    static void draw(Canvas canvas, LevelJoint.Type type, double x, double y, Color ink) {
        switch (type) {
            case HINGE -> {
                canvas.line(x - 3, y, x - 11, y + 10, 4, ink);
                canvas.line(x + 3, y, x + 11, y + 10, 4, ink);
                canvas.ring(x, y - 4, 6, STROKE, 1, ink);
                canvas.disc(x, y - 4, 2, ink);
            }
            case WELD -> {
                canvas.ring(x, y, 10, STROKE, 1, ink);
                canvas.line(x - 5, y - 5, x + 5, y + 5, STROKE, ink);
                canvas.line(x - 5, y + 5, x + 5, y - 5, STROKE, ink);
            }
            case WHEEL -> {
                path(canvas, STRUT, x, y, ink);
                canvas.ring(x, y + 5, 7, STROKE, 1, ink);
                canvas.disc(x, y + 5, 2, ink);
            }
            case SLIDE -> {
                canvas.line(x - 11, y + 5, x + 11, y + 5, STROKE, ink);
                canvas.line(x - 11, y, x - 11, y + 10, STROKE, ink);
                canvas.line(x + 11, y, x + 11, y + 10, STROKE, ink);
                canvas.frame(x - 6, y - 7, 12, 10, 2, ink);
            }
            case ROD -> {
                canvas.line(x - 8, y + 8, x + 8, y - 8, STROKE, ink);
                ends(canvas, x, y, 8, 8, ink);
            }
            case ROPE -> {
                path(canvas, SAG, x, y, ink);
                canvas.disc(x - 9, y - 8, END, ink);
                canvas.disc(x + 9, y - 8, END, ink);
            }
            case SPRING -> path(canvas, COIL, x, y, ink);
        }
    }

    private static void ends(
            Canvas canvas, double x, double y, double aside, double down, Color ink) {
        canvas.disc(x - aside, y + down, END, ink);
        canvas.disc(x + aside, y - down, END, ink);
    }

    private static void path(Canvas canvas, double[] xy, double x, double y, Color ink) {
        for (int i = 0; i + 3 < xy.length; i += 2) {
            canvas.line(x + xy[i], y + xy[i + 1], x + xy[i + 2], y + xy[i + 3], STROKE, ink);
        }
    }
}
