package rigibo.frontend.puzzle.picture;

import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.joint.RopeLine;

/** The sign of a verb on a dark disc: its shape and its colour show a click's action. */
public final class VerbMark {

    /** Radius of the disc, px, and of a disc under the pointer. */
    private static final double RADIUS = 12;

    private static final double LIFTED = 15;

    /** Width of the ring round the disc, px. */
    private static final double RING = 2.5;

    private VerbMark() {}

    /**
     * Draws it at a point of the screen, px; larger under the pointer, grey for a switch that is
     * off.
     */
    public static void draw(
            Canvas canvas, Verb verb, boolean isOn, double x, double y, boolean isMeant) {
        double radius = isMeant ? LIFTED : RADIUS;
        Color color = verb == Verb.SWITCH && !isOn ? Color.TEXT_DIM : color(verb);
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
        boolean isOn = joint.handling().isOn();
        draw(canvas, verb, isOn, camera.screenX(x), camera.screenY(y), false);
    }

    /** Draws it at a point of the world, m, as on or without a switch. */
    public static void draw(Canvas canvas, Camera camera, Verb verb, double x, double y) {
        draw(canvas, verb, true, camera.screenX(x), camera.screenY(y), false);
    }

    private static Color color(Verb verb) {
        return switch (verb) {
            case DELETE -> Color.RIGIBO;
            case CUT -> Color.BAD;
            case PULL -> Color.BRASS;
            case SWITCH -> Color.GOOD;
            case FREEZE -> Color.ICE;
            case LIGHT -> Color.RIGIBO;
        };
    }

    private static void glyph(
            Canvas canvas, Verb verb, double x, double y, double scale, Color color) {
        switch (verb) {
            case DELETE -> canvas.frame(x - 5, y - 5, 10, 10, 2, color);
            case CUT -> scissors(canvas, x, y, scale, color);
            case PULL -> pin(canvas, x, y, scale, color);
            case SWITCH -> power(canvas, x, y, scale, color);
            case FREEZE -> crystal(canvas, x, y, scale, color);
            case LIGHT -> flame(canvas, x, y, scale, color);
        }
    }

    /** Open blades to the right, two eyes to the left. */
    private static void scissors(Canvas canvas, double x, double y, double s, Color color) {
        for (int side = -1; side <= 1; side += 2) {
            canvas.line(x - 3 * s, y + 2 * side * s, x + 6.5 * s, y - 4 * side * s, 2 * s, color);
            canvas.ring(x - 4.5 * s, y + 3.4 * side * s, 2.4 * s, 1.6 * s, 1, color);
        }
    }

    /** An open ring with a stroke in its gap. */
    private static void power(Canvas canvas, double x, double y, double s, Color color) {
        double[] arc = new double[2 * 13];
        for (int i = 0; i < 13; i++) {
            double angle = Math.toRadians(-50 + i * 280 / 12.0);
            arc[2 * i] = x + 5.5 * s * Math.cos(angle);
            arc[2 * i + 1] = y + 0.8 * s + 5.5 * s * Math.sin(angle);
        }
        canvas.curve(arc, 13, 2 * s, color);
        canvas.line(x, y - 6.5 * s, x, y - 0.5 * s, 2 * s, color);
    }

    /** Three strokes through the middle. */
    private static void crystal(Canvas canvas, double x, double y, double s, Color color) {
        for (int i = 0; i < 3; i++) {
            double dx = 7 * s * Math.cos(Math.PI / 2 + i * Math.PI / 3);
            double dy = 7 * s * Math.sin(Math.PI / 2 + i * Math.PI / 3);
            canvas.line(x - dx, y - dy, x + dx, y + dy, 2 * s, color);
            canvas.disc(x + 0.8 * dx, y + 0.8 * dy, 1.8 * s, color);
            canvas.disc(x - 0.8 * dx, y - 0.8 * dy, 1.8 * s, color);
        }
    }

    /** A drop of fire with a bright heart. */
    private static void flame(Canvas canvas, double x, double y, double s, Color color) {
        canvas.disc(x, y + 2.2 * s, 4.6 * s, color);
        for (int side = -1; side <= 1; side += 2) {
            canvas.line(x + 2.6 * side * s, y, x + 0.6 * s, y - 7 * s, 3 * s, color);
        }
        canvas.disc(x, y + 3.4 * s, 2 * s, Color.TEXT);
    }

    /** A pin with a ring to pull it by. */
    private static void pin(Canvas canvas, double x, double y, double s, Color color) {
        canvas.ring(x, y - 3.4 * s, 3.4 * s, 1.9 * s, 1, color);
        canvas.line(x, y - 0.2 * s, x, y + 7 * s, 2.2 * s, color);
        canvas.line(x - 3 * s, y + 1.4 * s, x + 3 * s, y + 1.4 * s, 2 * s, color);
    }
}
