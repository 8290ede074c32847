package rigibo.lab.hardcase;

import rigibo.backend.GearJoint;
import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.PulleyJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WheelJoint;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Length;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.SplittableRandom;

/**
 * J7: mechanisms with one degree of freedom, driven at a given speed away from dead points, so that
 * all places follow from geometry. A slider crank: x = r·cos φ + √(l² − r²·sin²φ). A four-bar: its
 * joint is where two circles meet. A scissor lift of n crosses of bars L: n·L·sin φ high. A gear
 * pair under a torque τ: α = τ/(I₁ + I₂/ρ²). Atwood: a = (m₁ − m₂)g/(m₁ + m₂). A coupler on more
 * legs than it needs moves in a circle.
 */
final class Mechanisms {

    private static final double UNBOUNDED = Double.POSITIVE_INFINITY;

    private Mechanisms() {}

    static void run(Trial trial) {
        for (SplittableRandom random : trial.sampling().draws(2, 15)) {
            double size = 0.5 + 1.5 * random.nextDouble();
            double speed = (0.5 + 4 * random.nextDouble()) * (random.nextBoolean() ? 1 : -1);
            sliderCrank(trial, size, size * (1.5 + 3 * random.nextDouble()), speed);
            fourBar(trial, size, speed, random);
            scissors(trial, size, 1 + random.nextInt(5), Math.abs(speed) / 10);
            gears(trial, size, 0.3 + 3 * random.nextDouble(), speed);
            atwood(trial, 0.1 + random.nextDouble(), 0.1 + random.nextDouble());
            legs(trial, size, 3 + random.nextInt(4), speed);
        }
    }

    private static void place(Trial trial, RigidBody body, double x, double y, double extent) {
        double off = Math.hypot(body.x() - x, body.y() - y) / extent;
        trial.measure("place", off, "of its extent", JointLimits.PLACE);
    }

    /** A bar between two points. */
    private static RigidBody bar(WatchedPool pool, double ax, double ay, double bx, double by) {
        double length = Length.hypot(bx - ax, by - ay);
        return pool.add(
                Solid.box(length, 0.05)
                        .at((ax + bx) / 2, (ay + by) / 2)
                        .angle(Angle.atan2(by - ay, bx - ax))
                        .group(1));
    }

    /** A hinge that turns its second body at a speed, whatever torque that takes. */
    private static JointDefinition crank(RigidBody frame, RigidBody bar, double x, double speed) {
        return RevoluteJoint.at(frame, bar, x, 0).motor(speed, UNBOUNDED);
    }

    private static WatchedPool pool(Trial trial, boolean hasWeight) {
        WatchedPool pool = hasWeight ? trial.jointedEarth() : trial.jointedSpace();
        return pool.withEnergyOfItsOwn();
    }

    private static void sliderCrank(Trial trial, double r, double l, double speed) {
        trial.variant("slider crank, r " + r + ", l " + l + ", " + speed + " rad/s");
        WatchedPool pool = pool(trial, true);
        RigidBody frame = pool.hook(0, 0);
        RigidBody crank = bar(pool, 0, 0, r, 0);
        RigidBody rod = bar(pool, r, 0, r + l, 0);
        RigidBody slider = pool.add(Solid.box(0.3, 0.2).at(r + l, 0).group(1));
        pool.join(crank(frame, crank, 0, speed));
        pool.join(RevoluteJoint.at(crank, rod, r, 0));
        pool.join(RevoluteJoint.at(rod, slider, r + l, 0));
        pool.join(PrismaticJoint.along(frame, slider, r + l, 0, 0));
        while (pool.time() < 5) {
            pool.step();
            double phi = speed * pool.time();
            double across = r * Angle.sin(phi);
            double x = r * Angle.cos(phi) + Math.sqrt(l * l - across * across);
            place(trial, slider, x, 0, r);
            pool.measureJoints();
        }
    }

    /**
     * A four-bar whose crank is the shortest bar and, together with the frame, shorter than the
     * others, so that it turns fully.
     */
    private static void fourBar(Trial trial, double a, double speed, SplittableRandom random) {
        double frameLength = a * (2 + random.nextDouble());
        double coupler = a * (2.5 + random.nextDouble());
        double rocker = a * (2.5 + random.nextDouble());
        trial.variant("four-bar " + a + ", " + frameLength + ", " + coupler + ", " + rocker + " m");
        WatchedPool pool = pool(trial, false);
        RigidBody frame = pool.hook(0, 0);
        double[] joint = meeting(a, 0, coupler, frameLength, rocker);
        RigidBody crank = bar(pool, 0, 0, a, 0);
        RigidBody between = bar(pool, a, 0, joint[0], joint[1]);
        RigidBody swing = bar(pool, frameLength, 0, joint[0], joint[1]);
        pool.join(crank(frame, crank, 0, speed));
        pool.join(RevoluteJoint.at(crank, between, a, 0));
        pool.join(RevoluteJoint.at(between, swing, joint[0], joint[1]));
        pool.join(RevoluteJoint.at(frame, swing, frameLength, 0));
        while (pool.time() < 5) {
            pool.step();
            double phi = speed * pool.time();
            double[] at =
                    meeting(a * Angle.cos(phi), a * Angle.sin(phi), coupler, frameLength, rocker);
            place(trial, swing, (frameLength + at[0]) / 2, at[1] / 2, a);
            pool.measureJoints();
        }
    }

    /** The upper of the points at l from (x, y) and at r from (d, 0). */
    private static double[] meeting(double x, double y, double l, double d, double r) {
        double dx = d - x;
        double dy = -y;
        double apart = Length.hypot(dx, dy);
        double along = (apart * apart + l * l - r * r) / (2 * apart);
        double up = Math.sqrt(l * l - along * along);
        return new double[] {
            x + (along * dx - up * dy) / apart, y + (along * dy + up * dx) / apart
        };
    }

    private static void scissors(Trial trial, double length, int crosses, double speed) {
        trial.variant("scissor lift of " + crosses + " crosses of " + length + " m");
        WatchedPool pool = pool(trial, true);
        RigidBody frame = pool.hook(0, 0);
        double start = 0.4;
        double wide = length * Angle.cos(start);
        double high = length * Angle.sin(start);
        RigidBody rising = null;
        RigidBody falling = null;
        for (int k = 0; k < crosses; k++) {
            RigidBody up = bar(pool, 0, k * high, wide, (k + 1) * high);
            RigidBody down = bar(pool, wide, k * high, 0, (k + 1) * high);
            pool.join(RevoluteJoint.at(up, down, wide / 2, (k + 0.5) * high));
            if (k == 0) {
                pool.join(crank(frame, up, 0, speed));
                pool.join(WheelJoint.at(frame, down, wide, 0, 0));
            } else {
                pool.join(RevoluteJoint.at(falling, up, 0, k * high));
                pool.join(RevoluteJoint.at(rising, down, wide, k * high));
            }
            rising = up;
            falling = down;
        }
        double turn = 0.8;
        while (pool.time() < turn / speed && pool.time() < 5) {
            pool.step();
            double phi = start + speed * pool.time();
            double y = (crosses - 0.5) * length * Angle.sin(phi);
            place(trial, rising, length * Angle.cos(phi) / 2, y, length);
            pool.measureJoints();
        }
    }

    private static void gears(Trial trial, double radius, double ratio, double torque) {
        trial.variant("gears 1:" + ratio + ", " + torque + " N·m");
        WatchedPool pool = pool(trial, true);
        RigidBody frame = pool.hook(0, 0);
        RigidBody one = pool.add(Solid.disc(radius).group(1));
        RigidBody two = pool.add(Solid.disc(radius).at(5, 0).group(1));
        double most = Math.abs(torque);
        Joint first =
                pool.join(
                        RevoluteJoint.at(frame, one, 0, 0).motor(1e5 * Math.signum(torque), most));
        Joint second = pool.join(RevoluteJoint.at(frame, two, 5, 0));
        pool.join(GearJoint.of(first, second, ratio));
        double alpha = torque / (one.inertia() + two.inertia() / (ratio * ratio));
        while (pool.time() < 2) {
            pool.step();
            double truth = alpha * pool.time() * pool.time() / 2;
            Limits limits = JointLimits.PLACE;
            trial.relativeError("angle", one.angle(), truth, "of truth", limits);
            double other = two.angle() * ratio;
            trial.relativeError("angle of the other", other, -truth, "of truth", limits);
        }
    }

    private static void atwood(Trial trial, double one, double other) {
        trial.variant("Atwood's machine, " + one + " and " + other + " kg");
        WatchedPool pool = trial.jointedEarth();
        BodyDefinition weight = Solid.disc(0.1);
        RigidBody left = pool.add(weight.at(-1, 0).mass(one));
        RigidBody right = pool.add(weight.at(1, 0).mass(other));
        pool.join(PulleyJoint.over(left, right, 30));
        double truth = (other - one) * Trial.GRAVITY / (one + other);
        while (pool.time() < 1) {
            pool.step();
            double off = Math.abs(left.velocityY() / pool.time() - truth) / Trial.GRAVITY;
            trial.measure("acceleration", off, "of g", JointLimits.PLACE);
            off = Math.abs(left.y() + right.y());
            trial.measure("stretch of the rope", off, "m", JointLimits.ERROR);
        }
    }

    private static void legs(Trial trial, double length, int legs, double speed) {
        trial.variant("a coupler on " + legs + " legs of " + length + " m");
        WatchedPool pool = pool(trial, true);
        RigidBody frame = pool.hook(0, 0);
        RigidBody coupler = bar(pool, 0, length, legs - 1, length);
        for (int i = 0; i < legs; i++) {
            RigidBody leg = bar(pool, i, 0, i, length);
            pool.join(i == 0 ? crank(frame, leg, i, speed) : RevoluteJoint.at(frame, leg, i, 0));
            pool.join(RevoluteJoint.at(leg, coupler, i, length));
        }
        double middle = (legs - 1) / 2.0;
        // With all legs in one line it may go on either way: a dead point at a quarter turn.
        while (Math.abs(speed * pool.time()) < 1.2) {
            pool.step();
            double phi = speed * pool.time();
            double x = middle - length * Angle.sin(phi);
            place(trial, coupler, x, length * Angle.cos(phi), length);
            pool.measureJoints();
        }
    }
}
