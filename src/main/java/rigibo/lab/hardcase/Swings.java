package rigibo.lab.hardcase;

import rigibo.backend.DistanceJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Length;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Pendulum;
import rigibo.lab.truth.Solid;

import java.util.List;
import java.util.SplittableRandom;

/**
 * J1 to J3. A body on a hinge at d from its centre swings like a point at l = (I + m·d²)/(m·d), on
 * a rod like one at d, with the period of {@link Pendulum}, and keeps its energy.
 */
final class Swings {

    private static final List<Double> DEGREES = List.of(5.0, 90.0, 175.0);

    /** Limits of the energy's error, as a share of it; the mean may drift by a tenth. */
    private static final Limits ENERGY = Limits.of(1e-3, 1e-6);

    private static final Limits TREND = Limits.of(1e-4, 1e-7);
    private static final Limits PERIOD = Limits.of(1e-3, 1e-6);

    /** The error of joints below which a shorter step makes no visible difference, m. */
    private static final double SOLVED = 1e-8;

    /** Amount by which an observed order may fall short of 2, due to terms of the next order. */
    private static final double ORDER_LACKING = 0.1;

    /** Steps per second, from a quarter of the game's on; the last one serves as truth. */
    private static final int[] STEPS_PER_SECOND = {15, 30, 60, 16 * 60};

    private Swings() {}

    static void pendulums(Trial trial) {
        int i = 0;
        for (double degrees : DEGREES) {
            for (boolean isRod : new boolean[] {false, true}) {
                double radius = 0.02 + 0.3 * trial.sampling().random(i++).nextDouble();
                trial.variant(degrees + "°, " + (isRod ? "rod" : "hinge") + ", r " + radius);
                BodyDefinition bob = Solid.disc(radius);
                new Swing(bob, 1, 0, Math.toRadians(degrees), isRod).watch(trial, 100);
            }
        }
    }

    static void boxes(Trial trial) {
        for (SplittableRandom random : trial.sampling().draws(4, 40)) {
            double width = 0.1 + random.nextDouble();
            double height = 0.1 + random.nextDouble();
            double d = (0.1 + 2 * random.nextDouble()) * Length.hypot(width, height) / 2;
            double amplitude = Math.toRadians(5 + 170 * random.nextDouble());
            trial.variant(width + " × " + height + " m, d " + d + ", " + amplitude + " rad");
            BodyDefinition box = Solid.box(width, height);
            new Swing(box, d, 7 * random.nextDouble(), amplitude, false).watch(trial, 30);
        }
    }

    /**
     * A body that hangs on the origin.
     *
     * @param d from the origin to its centre, m
     * @param towards the direction from its centre to the origin in its own frame, rad
     * @param isRod whether a rod holds its centre, or a hinge itself
     */
    private record Swing(
            BodyDefinition body, double d, double towards, double amplitude, boolean isRod) {

        void watch(Trial trial, int swings) {
            WatchedPool pool = trial.jointedEarth().withEnergyOfItsOwn();
            RigidBody hook = pool.hook(0, 0);
            double x = d * Angle.sin(amplitude);
            double y = -d * Angle.cos(amplitude);
            RigidBody bob = pool.add(body.at(x, y).angle(amplitude + Math.PI / 2 - towards));
            pool.join(
                    isRod
                            ? DistanceJoint.rod(hook, 0, 0, bob, x, y)
                            : RevoluteJoint.at(hook, bob, 0, 0));
            double length = isRod ? d : d + bob.inertia() / (bob.mass() * d);
            double own = bob.mass() * Trial.GRAVITY * d * (1 - Math.cos(amplitude));
            double period = Pendulum.period(length, amplitude);
            Trend trend = new Trend(pool.energy(), own, swings * period);
            double first = 0;
            double last = 0;
            for (int crossings = 0; crossings <= 2 * swings; ) {
                double angle = Math.atan2(bob.x(), -bob.y());
                double rate = rate(bob);
                double time = pool.time();
                if (!(time < (swings + 2) * period)) {
                    break;
                }
                pool.step();
                trend.add(pool.time(), pool.energy());
                pool.measureJoints();
                double next = Math.atan2(bob.x(), -bob.y());
                if (angle * next < 0) {
                    double share = Pendulum.crossing(angle, rate, next, rate(bob));
                    last = time + Trial.DT * share;
                    first = crossings++ == 0 ? last : first;
                }
            }
            trial.relativeError("period", (last - first) / swings, period, "", PERIOD);
            trend.measure(trial);
        }

        private double rate(RigidBody bob) {
            double turn = bob.x() * bob.velocityY() - bob.y() * bob.velocityX();
            return turn / (d * d) * Trial.DT;
        }
    }

    /** The deviation of an energy, and its drift. */
    private static final class Trend {

        private static final int PARTS = 10;
        private final double start;
        private final double own;
        private final double horizon;
        private final double[] sums = new double[PARTS];
        private final int[] counts = new int[PARTS];
        private double worst;

        Trend(double start, double own, double horizon) {
            this.start = start;
            this.own = own;
            this.horizon = horizon;
        }

        void add(double time, double energy) {
            double off = (energy - start) / own;
            worst = Math.max(worst, Math.abs(off));
            int part = Math.min(PARTS - 1, (int) (PARTS * time / horizon));
            sums[part] += off;
            counts[part]++;
        }

        void measure(Trial trial) {
            int latest = PARTS - 1;
            while (latest > 0 && counts[latest] == 0) {
                // The period was so much too short that the swing had ended before.
                latest--;
            }
            double first = sums[0] / counts[0];
            double last = sums[latest] / counts[latest];
            trial.measure("energy", worst, "of its own", ENERGY);
            trial.measure("trend of energy", Math.abs(last - first), "of its own", TREND);
        }
    }

    static void doublePendulums(Trial trial) {
        for (SplittableRandom random : trial.sampling().draws(3, 20)) {
            double upper = 0.4 + random.nextDouble();
            double lower = 0.4 + random.nextDouble();
            double wild = (random.nextDouble() - 0.5) * 6;
            double calm = 0.3 + 0.7 * random.nextDouble();
            trial.variant(upper + " and " + lower + " m, at " + wild + " rad");
            energyOf(trial, upper, lower, wild);
            trial.variant(upper + " and " + lower + " m, at " + calm + " rad");
            wayOf(trial, upper, lower, calm);
        }
    }

    private static void energyOf(Trial trial, double upper, double lower, double angle) {
        WatchedPool pool = trial.jointedEarth().withEnergyOfItsOwn();
        hang(pool, upper, lower, angle);
        double hanging = hanging(pool, upper, lower);
        double start = pool.energy();
        Trend trend = new Trend(start, start - hanging, 10);
        while (pool.time() < 10) {
            pool.step();
            trend.add(pool.time(), pool.energy());
            pool.measureJoints();
        }
        trial.measure("energy", trend.worst, "of its own", ENERGY);
    }

    /** Energy where both links hang straight down, J. */
    private static double hanging(WatchedPool pool, double upper, double lower) {
        double first = pool.pool().bodies().get(1).mass() * upper / 2;
        double second = pool.pool().bodies().get(2).mass() * (upper + lower / 2);
        return -Trial.GRAVITY * (first + second);
    }

    private static void wayOf(Trial trial, double upper, double lower, double angle) {
        double[][] ends = new double[STEPS_PER_SECOND.length][];
        for (int i = 0; i < ends.length; i++) {
            WatchedPool pool = trial.jointedEarth().withEnergyOfItsOwn();
            RigidBody end = hang(pool, upper, lower, angle);
            int between = STEPS_PER_SECOND[i] / STEPS_PER_SECOND[0];
            ends[i] = new double[4 * STEPS_PER_SECOND[0]];
            for (int look = 0; look < ends[i].length; look += 2) {
                for (int step = 0; step < between; step++) {
                    pool.step(1.0 / STEPS_PER_SECOND[i]);
                }
                ends[i][look] = end.x();
                ends[i][look + 1] = end.y();
            }
        }
        trial.measure("way", Places.farthestApart(ends[2], ends[3]), "m", JointLimits.PLACE);
        double coarse = Places.farthestApart(ends[0], ends[1]);
        double fine = Places.farthestApart(ends[1], ends[2]);
        double order = fine < SOLVED ? 2 : Math.log(coarse / fine) / Math.log(2);
        trial.measure("order below 2", Math.max(0, 2 - order), "", ORDER_LACKING);
    }

    /** Two bars, the lower one bent back by a third of the angle; returns the lower one. */
    private static RigidBody hang(WatchedPool pool, double upper, double lower, double angle) {
        RigidBody hook = pool.hook(0, 0);
        double knee = angle * 2 / 3;
        double x = upper * Angle.sin(angle);
        double y = -upper * Angle.cos(angle);
        RigidBody first = pool.add(Solid.box(0.1, upper).at(x / 2, y / 2).angle(angle).group(1));
        double endX = x + lower / 2 * Angle.sin(knee);
        double endY = y - lower / 2 * Angle.cos(knee);
        RigidBody second = pool.add(Solid.box(0.08, lower).at(endX, endY).angle(knee).group(1));
        pool.join(RevoluteJoint.at(hook, first, 0, 0));
        pool.join(RevoluteJoint.at(first, second, x, y));
        return second;
    }
}
