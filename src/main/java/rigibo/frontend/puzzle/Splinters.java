package rigibo.frontend.puzzle;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Small pieces that fly off a deleted box, and confetti when a level is won. For the eye only. */
final class Splinters {

    private static final double STEP = 1.0 / 60;
    private static final double GRAVITY = -9.81;
    private static final int PER_BOX = 26;
    private static final int PER_WIN = 120;
    private static final Color[] CONFETTI = {Color.GOOD, Color.BAD, Color.BRASS, Color.ICE};

    private final SplittableRandom random = new SplittableRandom(1);
    private final List<Splinter> flying = new ArrayList<>();

    /** One piece; s, m, m/s, rad, rad/s. */
    private static final class Splinter {
        double left;
        double x;
        double y;
        double vx;
        double vy;
        double angle;
        double spin;
        double size;
        Color color;
    }

    /** A box of a width bursts at a place, m. */
    void burst(double x, double y, double width) {
        for (int i = 0; i < PER_BOX; i++) {
            fly(x + between(-width, width) / 2, y + between(-width, width) / 2, 3, Color.RIGIBO);
        }
    }

    /** Confetti from a place, m. */
    void celebrate(double x, double y) {
        for (int i = 0; i < PER_WIN; i++) {
            fly(x, y, 7, CONFETTI[i % CONFETTI.length]);
        }
    }

    void step() {
        for (Splinter splinter : flying) {
            splinter.left -= STEP;
            splinter.vy += GRAVITY * STEP;
            splinter.x += splinter.vx * STEP;
            splinter.y += splinter.vy * STEP;
            splinter.angle += splinter.spin * STEP;
        }
        flying.removeIf(splinter -> splinter.left <= 0);
    }

    void draw(Canvas canvas) {
        for (Splinter splinter : flying) {
            Color faded = splinter.color.alpha(Math.min(1, 2 * splinter.left));
            canvas.particle(splinter.x, splinter.y, splinter.size, splinter.angle, faded);
        }
    }

    private void fly(double x, double y, double speed, Color color) {
        Splinter splinter = new Splinter();
        splinter.left = between(0.5, 1.2);
        splinter.x = x;
        splinter.y = y;
        splinter.vx = between(-speed, speed) / 2;
        splinter.vy = between(0, speed);
        splinter.angle = between(0, 6);
        splinter.spin = between(-9, 9);
        splinter.size = between(0.04, 0.11);
        splinter.color = color;
        flying.add(splinter);
    }

    private double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }
}
