package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.joint.RopeLine;

/** The sign of a verb on a dark disc: its shape and its colour tell what a click does. */
public final class VerbMark {

    /** Radius of the disc, px, and of one that is pointed at. */
    private static final double RADIUS = 12;

    private static final double LIFTED = 15;

    /** Width of the ring round the disc, px. */
    private static final double RING = 2.5;

    private VerbMark() {}

    /** Draws it at a point of the screen, px; larger if it is pointed at. */
    public static void draw(Canvas canvas, Verb verb, double x, double y, boolean isMeant) {
        double radius = isMeant ? LIFTED : RADIUS;
        Color color = color(verb);
        canvas.disc(x, y, radius + 1.5, Color.NIGHT);
        canvas.disc(x, y, radius, isMeant ? Color.PANEL_LIT : Color.DUSK_TOP);
        canvas.ring(x, y, radius, RING, 1, color);
        glyph(canvas, verb, x, y, radius / RADIUS, color);
    }

    /** Draws it on a joint where a level places it. */
    public static void draw(Canvas canvas, Camera camera, Verb verb, LevelJoint joint) {
        double x = joint.x();
        double y = joint.y();
        if (joint.type() == LevelJoint.Type.ROPE) {
            RopeLine line = RopeLine.hanging(x, y, joint.toX(), joint.toY(), joint.length());
            x = line.x(0.5);
            y = line.y(0.5);
        }
        draw(canvas, verb, camera.screenX(x), camera.screenY(y), false);
    }

    private static Color color(Verb verb) {
        return switch (verb) {
            case DELETE -> Color.RIGIBO;
            case CUT -> Color.BAD;
            case PULL -> Color.BRASS;
        };
    }

    private static void glyph(
            Canvas canvas, Verb verb, double x, double y, double scale, Color color) {
        switch (verb) {
            case DELETE -> canvas.frame(x - 5, y - 5, 10, 10, 2, color);
            case CUT -> scissors(canvas, x, y, scale, color);
            case PULL -> pin(canvas, x, y, scale, color);
        }
    }

    /** Open blades to the right, two eyes to the left. */
    private static void scissors(Canvas canvas, double x, double y, double s, Color color) {
        for (int side = -1; side <= 1; side += 2) {
            canvas.line(x - 3 * s, y + 2 * side * s, x + 6.5 * s, y - 4 * side * s, 2 * s, color);
            canvas.ring(x - 4.5 * s, y + 3.4 * side * s, 2.4 * s, 1.6 * s, 1, color);
        }
    }

    /** A pin with a ring to pull it by. */
    private static void pin(Canvas canvas, double x, double y, double s, Color color) {
        canvas.ring(x, y - 3.4 * s, 3.4 * s, 1.9 * s, 1, color);
        canvas.line(x, y - 0.2 * s, x, y + 7 * s, 2.2 * s, color);
        canvas.line(x - 3 * s, y + 1.4 * s, x + 3 * s, y + 1.4 * s, 2 * s, color);
    }
}
