package rigibo.lab.hardcase;

import rigibo.backend.DistanceJoint;
import rigibo.backend.Joint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Pendulum;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * J6, J11 and J17. An impact passes through joints at once: joined bodies respond with their common
 * effective mass at the point struck, along its normal.
 */
final class JointImpacts {

    private static final Limits OTHERS = Limits.of(1e-2, 1e-6);
    private static final Limits TENSION = Limits.of(1e-2, 1e-6);
    private static final Limits MOMENTUM = Limits.of(1e-3, 1e-9);

    private JointImpacts() {}

    static void cradles(Trial trial) {
        for (SplittableRandom random : trial.sampling().draws(2, 15)) {
            double radius = 0.05 + 0.15 * random.nextDouble();
            double length = 1 + 2 * random.nextDouble();
            double angle = 0.2 + 0.6 * random.nextDouble();
            trial.variant("discs of " + radius + " m on " + length + " m, from " + angle + " rad");
            swing(trial, radius, length, angle);
        }
    }

    private static void swing(Trial trial, double radius, double length, double angle) {
        int count = 5;
        WatchedPool pool = trial.jointedEarth().withEnergyOfItsOwn();
        List<RigidBody> row = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double from = 2 * radius * i;
            double x = from - (i == 0 ? length * Math.sin(angle) : 0);
            double y = -length * (i == 0 ? Math.cos(angle) : 1);
            RigidBody disc = pool.add(Solid.disc(radius, 0, 1).at(x, y));
            pool.join(DistanceJoint.rod(pool.hook(from, 0), from, 0, disc, x, y));
            row.add(disc);
        }
        double height = length * (1 - Math.cos(angle));
        double speed = Math.sqrt(2 * Trial.GRAVITY * height);
        double half = Pendulum.period(length, angle) / 2;
        for (int swing = 1; swing <= 20; swing++) {
            while (pool.time() < swing * half - Trial.DT / 2) {
                pool.step();
                pool.measureJoints();
            }
            RigidBody risen = row.get(swing % 2 == 0 ? 0 : count - 1);
            double rise = rise(risen, length) / height;
            trial.measure("height of the last", Math.abs(rise - 1), "of the first's", OTHERS);
            for (RigidBody disc : row) {
                double ofOthers = disc == risen ? 0 : speed(disc) / speed;
                trial.measure("speed of the others", ofOthers, "of v", OTHERS);
            }
        }
    }

    /** The height of its apex by its energy, since some of it is still kinetic near the apex, m. */
    private static double rise(RigidBody disc, double length) {
        return disc.y() + length + speed(disc) * speed(disc) / (2 * Trial.GRAVITY);
    }

    private static double speed(RigidBody body) {
        return Math.hypot(body.velocityX(), body.velocityY());
    }

    static void ropes(Trial trial) {
        for (SplittableRandom random : trial.sampling().draws(3, 20)) {
            double ratio = Math.pow(10, 2 * random.nextDouble() - 1);
            double speed = Math.pow(10, 2 * random.nextDouble() - 1);
            double aside = 0.5 * random.nextDouble();
            trial.variant("1:" + ratio + " at " + speed + " m/s, " + aside + " m aside");
            jerk(trial, ratio, speed, aside);
            double length = 0.5 + 2 * random.nextDouble();
            double faster = 1.02 + random.nextDouble();
            trial.variant("a turn on " + length + " m, " + faster + " times as fast as needed");
            turn(trial, length, faster);
        }
    }

    /**
     * One body flies away from the other, which rests, until the rope is taut. Along the rope both
     * go on at m·u/(m + M), across it each keeps its velocity.
     */
    private static void jerk(Trial trial, double ratio, double speed, double aside) {
        WatchedPool pool = trial.jointedSpace();
        BodyDefinition disc = Solid.disc(0.1);
        RigidBody rests = pool.add(disc.mass(ratio));
        RigidBody flies = pool.add(disc.mass(1).at(0.3, aside).velocity(speed, 0));
        pool.join(DistanceJoint.rope(rests, 0, 0, flies, 0.3, aside, 1));
        double taut = Math.sqrt(1 - aside * aside);
        while (pool.time() < (taut - 0.3) / speed) {
            pool.step();
        }
        // In the next step the rope is taut; then it turns at the rate that the jerk left.
        pool.step();
        double along = (taut * speed) / (1 + ratio);
        trial.relativeError("momentum", pool.pool().momentumX(), speed, "of all", MOMENTUM);
        double angular = (aside * speed) * -1;
        double spin = pool.pool().angularMomentum();
        trial.measure("angular momentum", Math.abs(spin - angular) / speed, "of m·v", MOMENTUM);
        double kinetic = (1 + ratio) * along * along / 2 + aside * aside * speed * speed / 2;
        double off = Math.abs(pool.pool().kineticEnergy() - kinetic) / (speed * speed / 2);
        trial.measure("energy left", off, "of the start", TENSION);
    }

    /** T = m·(g·cos θ + v²/r), v² = v₀² − 2gr·(1 − cos θ). */
    private static void turn(Trial trial, double length, double faster) {
        WatchedPool pool = trial.jointedEarth().withEnergyOfItsOwn();
        double v = faster * Math.sqrt(5 * Trial.GRAVITY * length);
        RigidBody bob = pool.add(Solid.disc(0.1).at(0, -length).mass(1).velocity(v, 0));
        RigidBody hook = pool.hook(0, 0);
        Joint rope = pool.join(DistanceJoint.rope(hook, 0, 0, bob, 0, -length, length));
        while (pool.time() < 4) {
            double x = pull(bob, length, v, true);
            double y = pull(bob, length, v, false);
            pool.step();
            // The mean force over a step is the change of momentum, here of the true velocities.
            x = (pull(bob, length, v, true) - x) / Trial.DT;
            y = (pull(bob, length, v, false) - y) / Trial.DT + Trial.GRAVITY;
            double off = Math.hypot(rope.reactionForceX() - x, rope.reactionForceY() - y);
            double most = Trial.GRAVITY + v * v / length;
            trial.measure("tension", off / most, "of its most", TENSION);
            pool.measureJoints();
        }
    }

    /** The true velocity at the bob's place, along x or y, m/s. */
    private static double pull(RigidBody bob, double length, double v, boolean isX) {
        double angle = Math.atan2(bob.x(), -bob.y());
        double cos = Math.cos(angle);
        double speed = Math.sqrt(v * v - 2 * Trial.GRAVITY * length * (1 - cos));
        return isX ? speed * cos : speed * Math.sin(angle);
    }

    static void strikes(Trial trial) {
        int count = trial.sampling().count(4, 40);
        for (int i = 0; i < count; i++) {
            SplittableRandom random = trial.sampling().random(i);
            double elasticity = i % 4 == 0 ? 1 : random.nextDouble();
            double mass = Math.pow(10, 2 * random.nextDouble() - 1);
            double speed = Math.pow(10, 2 * random.nextDouble() - 0.5);
            double at = random.nextDouble() - 0.5;
            String words = ", " + mass + " kg at " + speed + " m/s, e " + elasticity + ", " + at;
            trial.variant("two boxes in space" + words);
            strikeFree(trial, mass, speed, at, elasticity);
            trial.variant("a bar on a hinge" + words);
            strikeHung(trial, mass, speed, Math.abs(at) + 0.2, elasticity);
        }
    }

    private static BodyDefinition ball(double mass, double elasticity) {
        return Solid.disc(0.1, 0, elasticity).mass(mass);
    }

    /**
     * Two boxes on a hinge at (½, 0) at rest; a ball falls on the left one at x. With m, I and a =
     * ½ of either box the hinge transmits H = J·(1/m + a·x/I)/(2/m + 2a²/I), and the boxes respond
     * with k = 1/m + x²/I − (H/J)·(1/m + a·x/I).
     */
    private static void strikeFree(
            Trial trial, double mass, double speed, double at, double elasticity) {
        WatchedPool pool = trial.jointedSpace();
        if (trial.preset() == Preset.DRAFT) {
            // At DRAFT the leapfrog errs by (ωh)² in energy, and these turn by a radian in a
            // substep.
            pool.withEnergyOfItsOwn();
        }
        BodyDefinition box = Solid.box(1, 0.4, 0, 0);
        RigidBody left = pool.add(box);
        RigidBody right = pool.add(box.at(1, 0));
        pool.join(RevoluteJoint.at(left, right, 0.5, 0));
        double height = 0.3 + 1.3 * speed * Trial.DT;
        RigidBody ball = pool.add(ball(mass, elasticity).at(at, height).velocity(0, -speed));
        double angular = pool.pool().angularMomentum();
        for (int i = 0; i < 2; i++) {
            pool.step();
        }
        double handed = 1 / left.mass() + 0.5 * at / left.inertia();
        double share = handed / (2 / left.mass() + 0.5 / left.inertia());
        double answer = 1 / left.mass() + at * at / left.inertia() - share * handed;
        double impulse = (1 + elasticity) * speed / (1 / mass + answer);
        double truth = -speed + impulse / mass;
        double off = Math.abs(ball.velocityY() - truth) / speed;
        trial.measure("speed of what struck", off, "of v", MOMENTUM);
        double momentum = pool.pool().momentumY();
        trial.relativeError("momentum", momentum, -(mass * speed), "of all", MOMENTUM);
        off = Math.abs(pool.pool().angularMomentum() - angular) / (mass * speed);
        trial.measure("angular momentum", off, "of m·v", MOMENTUM);
        pool.measureJoints();
    }

    /** A ball strikes a hanging bar at a depth d: J = (1 + e)·v/(1/m + d²/I) about the hinge. */
    private static void strikeHung(
            Trial trial, double mass, double speed, double depth, double elasticity) {
        WatchedPool pool = trial.jointedSpace();
        RigidBody bar = pool.add(Solid.box(0.2, 1, 0, 0).at(0, -0.5));
        pool.join(RevoluteJoint.at(pool.hook(0, 0), bar, 0, 0));
        double away = 0.2 + 1.3 * speed * Trial.DT;
        RigidBody ball = pool.add(ball(mass, elasticity).at(-away, -depth).velocity(speed, 0));
        for (int i = 0; i < 2; i++) {
            pool.step();
        }
        double inertia = bar.inertia() + bar.mass() / 4;
        double impulse = (1 + elasticity) * speed / (1 / mass + depth * depth / inertia);
        double truth = speed - impulse / mass;
        double off = Math.abs(ball.velocityX() - truth) / speed;
        trial.measure("speed of what struck", off, "of v", MOMENTUM);
        double angular = mass * ball.velocityX() * depth + inertia * bar.angularVelocity();
        double brought = mass * speed * depth;
        trial.relativeError(
                "angular momentum about the hinge", angular, brought, "of all", MOMENTUM);
        pool.measureJoints();
    }
}
