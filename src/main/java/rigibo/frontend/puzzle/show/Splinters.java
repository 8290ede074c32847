package rigibo.frontend.puzzle.show;

import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.session.Pose;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Small pieces that fly off a deleted box, and confetti when a level is won. For display only. */
final class Splinters {

    private static final double GRAVITY = -9.81;

    /** Acceleration of falling paper, m/s², and the rate at which air slows it down, 1/s. */
    private static final double PAPER_GRAVITY = -3.5;

    private static final double PAPER_DRAG = 1.6;

    /** Splinters per m² of a box, and the smallest and largest number of them. */
    private static final double PER_AREA = 55;

    private static final int LEAST = 14;
    private static final int MOST = 48;

    private static final int PER_WIN = 140;
    private static final Color[] CONFETTI = {
        Color.GOOD, Color.BAD, Color.BRASS, Color.ICE, Color.TEXT
    };

    private final SplittableRandom random = new SplittableRandom(1);
    private final List<Splinter> flying = new ArrayList<>();

    /** One piece; s, m, m/s, rad, rad/s. */
    private static final class Splinter {
        boolean isPaper;
        double left;
        double x;
        double y;
        double velocityX;
        double velocityY;
        double angle;
        double spin;
        double size;
        Color color;
    }

    /** Makes a body burst in its own colour. */
    void burst(Remains remains) {
        Pose from = remains.pose();
        double width = remains.width();
        double height = remains.height();
        int count = (int) Math.max(LEAST, Math.min(MOST, PER_AREA * width * height));
        double cos = Math.cos(from.angle());
        double sin = Math.sin(from.angle());
        for (int i = 0; i < count; i++) {
            double along = between(-width, width) / 2;
            double up = between(-height, height) / 2;
            Splinter splinter =
                    fly(from.x() + cos * along - sin * up, from.y() + sin * along + cos * up);
            splinter.velocityX = 1.5 * (splinter.x - from.x()) + between(-1.2, 1.2);
            splinter.velocityY = 1.6 * (splinter.y - from.y()) + between(0.2, 3.2);
            splinter.size = between(0.04, 0.13);
            splinter.left = between(0.45, 1.1);
            splinter.color = shade(remains.skin().color, between(0.7, 1.2));
        }
    }

    /** Throws confetti from a point, m. */
    void celebrate(double x, double y) {
        for (int i = 0; i < PER_WIN; i++) {
            Splinter splinter = fly(x, y);
            double speed = between(2, 9);
            double direction = between(0.12, 0.88) * Math.PI;
            splinter.isPaper = true;
            splinter.velocityX = speed * Math.cos(direction);
            splinter.velocityY = speed * Math.sin(direction);
            splinter.size = between(0.06, 0.13);
            splinter.left = between(1.4, 3.2);
            splinter.color = CONFETTI[i % CONFETTI.length];
        }
    }

    void step() {
        for (Splinter splinter : flying) {
            double drag = splinter.isPaper ? Math.exp(-PAPER_DRAG * Steps.SECONDS) : 1;
            double gravity = splinter.isPaper ? PAPER_GRAVITY : GRAVITY;
            splinter.left -= Steps.SECONDS;
            splinter.velocityX *= drag;
            splinter.velocityY = splinter.velocityY * drag + gravity * Steps.SECONDS;
            splinter.x += splinter.velocityX * Steps.SECONDS;
            splinter.y += splinter.velocityY * Steps.SECONDS;
            splinter.angle += splinter.spin * Steps.SECONDS;
        }
        flying.removeIf(splinter -> splinter.left <= 0);
    }

    void clear() {
        flying.clear();
    }

    void draw(Canvas canvas) {
        for (Splinter splinter : flying) {
            Color faded = splinter.color.alpha(Math.min(1, 3 * splinter.left));
            canvas.particle(splinter.x, splinter.y, splinter.size, splinter.angle, faded);
        }
    }

    private Splinter fly(double x, double y) {
        Splinter splinter = new Splinter();
        splinter.x = x;
        splinter.y = y;
        splinter.angle = between(0, 6);
        splinter.spin = between(-9, 9);
        flying.add(splinter);
        return splinter;
    }

    private static Color shade(Color color, double brightness) {
        float by = (float) brightness;
        return new Color(
                Math.min(1, by * color.red()),
                Math.min(1, by * color.green()),
                Math.min(1, by * color.blue()),
                1);
    }

    private double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }
}
