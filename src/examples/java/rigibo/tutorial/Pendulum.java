package rigibo.tutorial;

import rigibo.backend.DistanceJoint;
import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

/** Chapter 3: a ball swings on a rod. */
public final class Pendulum {

    static final double STEP = 1.0 / 60; // s
    static final double GRAVITY = 9.81; // m/s²
    static final double LENGTH = 2; // m
    static final double LIFT = Angle.ofDegrees(60);

    private Pendulum() {}

    /** A pool that simulates gravity and joints, which need contacts, and nothing else. */
    static Pool open() {
        Effects few = Effects.of(new Gravity(0, -GRAVITY), new Contacts(), new Joints());
        return new Pool(few, Accuracy.GAME);
    }

    /** Adds a nail at (0, 3), and a ball that hangs from it by a rod, lifted to the left. */
    static Joint build(Pool pool) {
        double x = -LENGTH * Angle.sin(LIFT);
        double y = 3 - LENGTH * Angle.cos(LIFT);
        RigidBody nail = pool.add(BodyDefinition.fixed(Polygon.box(0.2, 0.2)).at(0, 3));
        RigidBody ball = pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(x, y));
        return pool.join(DistanceJoint.rod(nail, 0, 3, ball, x, y));
    }

    /** The period: 2π√(L/g) over the arithmetic-geometric mean of 1 and the cosine of LIFT/2. */
    static double period() {
        double a = 1;
        double b = Angle.cos(LIFT / 2);
        while (a - b > 1e-15) {
            double mean = (a + b) / 2;
            b = Math.sqrt(a * b);
            a = mean;
        }
        return 2 * Math.PI * Math.sqrt(LENGTH / GRAVITY) / a;
    }

    /** Prints the time of ten swings, and the pull in the rod at the lowest point. */
    public static void main(String[] arguments) {
        Pool pool = open();
        Joint rod = build(pool);
        RigidBody ball = rod.b();
        int passes = 0;
        double first = 0;
        double last = 0;
        double pull = 0;
        while (passes < 21) {
            double before = ball.x();
            pool.step(STEP);
            if (before < 0 != ball.x() < 0) {
                last = pool.time() - STEP * ball.x() / (ball.x() - before);
                first = passes == 0 ? last : first;
                passes++;
            }
            pull = Math.max(pull, rod.reactionForce());
        }
        System.out.printf(
                "ten swings take %.3f s, by formula %.3f s%n", last - first, 10 * period());
        double weight = ball.mass() * GRAVITY;
        System.out.printf(
                "the rod pulls by up to %.2f weights, by formula %.2f%n",
                pull / weight, 3 - 2 * Angle.cos(LIFT));
    }
}
