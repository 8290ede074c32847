package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings.Motion;

/**
 * A small moving picture of what a click does in a world: a box goes and the ball falls, a rope is
 * cut, a wheel is switched on, what floats is frozen. Plates lie over bodies, so that it is drawn
 * with a pen.
 */
final class WorldPicture {

    /** px. */
    static final double WIDTH = 96;

    static final double HEIGHT = 84;

    /** Time from one click to the next, and to the click, s. */
    private static final double ROUND = 4;

    private static final double CLICK = 1.6;

    /** Time for which the ring of a click grows, s. */
    private static final double RIPPLE = 0.4;

    /** Time of the picture that stands for all where little is to move, s. */
    private static final double STILL = CLICK + RIPPLE / 2;

    /** px/s². */
    private static final double GRAVITY = 260;

    private static final double BALL = 10;
    private static final double BOX = 26;
    private static final double MIDDLE = WIDTH / 2;
    private static final double FLOOR = 78;

    private final Canvas canvas;
    private final double left;
    private final double top;

    /** Since the round began, s. */
    private final double time;

    private WorldPicture(Canvas canvas, double left, double top, double time) {
        this.canvas = canvas;
        this.left = left;
        this.top = top;
        this.time = time;
    }

    /** Draws the picture of a world, from 1, after a number of steps. */
    static void draw(Canvas canvas, int world, double left, double top, int steps, Motion motion) {
        double time = motion == Motion.FULL ? steps * Scene.STEP % ROUND : STILL;
        WorldPicture picture = new WorldPicture(canvas, left, top, time);
        switch (world) {
            case 1 -> picture.boxes();
            case 2 -> picture.ropes();
            case 3 -> picture.machines();
            default -> picture.elements();
        }
    }

    private void boxes() {
        line(18, FLOOR, 78, FLOOR, 4, Color.STONE);
        double upper = FLOOR - 2 - 1.5 * BOX;
        box(FLOOR - 2 - BOX / 2);
        if (time < CLICK) {
            box(upper);
        }
        double fallen = Math.min(BOX, GRAVITY * sinceClick() * sinceClick() / 2);
        ball(MIDDLE, upper - BOX / 2 - BALL + fallen);
        click(MIDDLE, upper);
    }

    /** A weight swings on a rope, and flies on from where that is cut. */
    private void ropes() {
        double length = 42;
        double rate = 4;
        double swung = Math.min(time, CLICK);
        double angle = 0.5 * Math.cos(rate * swung);
        double speed = -0.5 * rate * Math.sin(rate * swung) * length;
        double since = sinceClick();
        double x = MIDDLE + length * Math.sin(angle) + speed * Math.cos(angle) * since;
        double y = 8 + length * Math.cos(angle) - speed * Math.sin(angle) * since;
        y += GRAVITY * since * since / 2;
        double end = time < CLICK ? 1 : 0.4;
        double ropeX = MIDDLE + end * length * Math.sin(angle);
        double ropeY = 8 + end * length * Math.cos(angle);
        line(22, 6, 74, 6, 5, Color.STONE);
        line(MIDDLE, 8, ropeX, ropeY, 2.5, Color.BRASS);
        if (y < FLOOR) {
            disc(x, y, BALL, Color.STONE);
        }
        click(MIDDLE + length / 2 * Math.sin(angle), 8 + length / 2 * Math.cos(angle));
    }

    /** A wheel that a click sets going. */
    private void machines() {
        double y = 42;
        double angle = 3 * sinceClick();
        canvas.ring(left + MIDDLE, top + y, 30, 6, 1, Color.WOOD);
        for (int spoke = 0; spoke < 6; spoke++) {
            double at = angle + spoke * Math.PI / 3;
            double x = 28 * Math.cos(at);
            line(MIDDLE, y, MIDDLE + x, y + 28 * Math.sin(at), 4, Color.WOOD);
        }
        disc(MIDDLE, y, 10, Color.DUSK_TOP);
        Color sign = time < CLICK ? Color.TEXT_DIM : Color.GOOD;
        canvas.ring(left + MIDDLE, top + y, 8, 2.5, 1, sign);
        click(MIDDLE, y);
    }

    /** A ball that floats, until it is frozen. */
    private void elements() {
        double surface = 46;
        ball(MIDDLE, surface + 4 * Math.sin(4 * Math.min(time, CLICK)));
        canvas.panel(left, top + surface, WIDTH, HEIGHT - surface, 6, Color.ICE.alpha(0.35));
        if (time >= CLICK) {
            double y = surface + 4 * Math.sin(4 * CLICK);
            canvas.frame(left + MIDDLE - 15, top + y - 15, 30, 30, 6, Color.ICE);
        }
        click(MIDDLE, surface);
    }

    private double sinceClick() {
        return Math.max(0, time - CLICK);
    }

    /** The ring of a click, where and while there is one. */
    private void click(double x, double y) {
        double share = (time - CLICK) / RIPPLE;
        if (share >= 0 && share < 1) {
            Color ring = Color.BRASS.alpha(1 - share);
            canvas.ring(left + x, top + y, 8 + 14 * share, 3, 1, ring);
        }
    }

    private void box(double y) {
        double half = BOX / 2;
        canvas.panel(left + MIDDLE - half, top + y - half, BOX, BOX - 1, 4, Color.RIGIBO);
        for (int side = -1; side <= 1; side += 2) {
            disc(MIDDLE + 5 * side, y - 2, 2.5, Color.DUSK_TOP);
        }
    }

    private void ball(double x, double y) {
        disc(x, y, BALL, Color.BALL);
        line(x - BALL + 2, y, x + BALL - 2, y, 5, Color.DUSK_TOP);
    }

    private void disc(double x, double y, double radius, Color color) {
        canvas.disc(left + x, top + y, radius, color);
    }

    private void line(double x, double y, double toX, double toY, double width, Color color) {
        canvas.line(left + x, top + y, left + toX, top + toY, width, color);
    }
}
