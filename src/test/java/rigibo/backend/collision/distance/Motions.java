package rigibo.backend.collision.distance;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;

import java.util.Random;

/** Motions for tests, from a few numbers or from a seed. */
public final class Motions {

    private Motions() {}

    /** A motion at rest at time 0. */
    public static Motion resting(Shape shape, double x, double y, double angle) {
        Motion motion = new Motion();
        motion.outline = shape.outline(0);
        motion.x = x;
        motion.y = y;
        motion.angle = angle;
        return motion;
    }

    /** A straight, uniform motion from time 0 on. */
    public static Motion moving(
            Shape shape, double x, double y, double velocityX, double velocityY) {
        Motion motion = resting(shape, x, y, 0);
        motion.velocityX = velocityX;
        motion.velocityY = velocityY;
        return motion;
    }

    /**
     * A random motion within 3 m of the origin: with and without spin, gravity, drag, and torque.
     */
    public static Motion any(Random random, double speed, double spin) {
        Motion motion =
                moving(
                        anyShape(random),
                        between(random, -3, 3),
                        between(random, -3, 3),
                        between(random, -speed, speed),
                        between(random, -speed, speed));
        motion.angle = between(random, 0, 7);
        motion.spin = between(random, -spin, spin);
        motion.accelerationY = random.nextBoolean() ? -9.81 : 0;
        motion.angularAcceleration = random.nextInt(4) == 0 ? between(random, -50, 50) : 0;
        motion.drag = random.nextInt(4) == 0 ? between(random, 0, 5) : 0;
        return motion;
    }

    /** A disc, or a shape with edges, of 0.1 to 2 m. */
    public static Shape anyShape(Random random) {
        return random.nextInt(6) == 0
                ? new Circle(between(random, 0.05, 1))
                : anyShapeWithEdges(random);
    }

    /** A capsule, box, rod, triangle or polygon of 0.1 to 2 m, sharp or rounded. */
    public static Shape anyShapeWithEdges(Random random) {
        Polygon sharp = anyPolygon(random);
        return switch (random.nextInt(4)) {
            case 0 -> new Capsule(between(random, 0.05, 1), between(random, 0.02, 0.5));
            case 1 -> sharp.rounded(between(random, 0.01, 0.5));
            default -> sharp;
        };
    }

    private static Polygon anyPolygon(Random random) {
        return switch (random.nextInt(4)) {
            case 1 -> Polygon.box(between(random, 0.1, 2), between(random, 0.1, 1));
            case 2 -> Polygon.box(2, 0.05);
            case 3 -> Polygon.regular(3 + random.nextInt(20), between(random, 0.2, 1));
            default -> Polygon.of(0, 0, between(random, 1, 2), between(random, 0, 0.5), 0.3, 1);
        };
    }

    public static double between(Random random, double least, double most) {
        return least + random.nextDouble() * (most - least);
    }

    /** The distance of two moving shapes at a time, m; negative in overlap. */
    public static double gap(Motion a, Motion b, double time) {
        Pose poseA = new Pose();
        Pose poseB = new Pose();
        a.poseAt(time, poseA);
        b.poseAt(time, poseB);
        return new Distance().measure(a.outline, poseA, b.outline, poseB);
    }
}
