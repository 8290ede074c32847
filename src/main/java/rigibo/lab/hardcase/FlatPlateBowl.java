package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.lab.truth.Solid;

import java.util.List;

/**
 * A smooth disc or box slides to and fro in a bowl of flat plates, e = 0. Truth: at a kink of the
 * angle δ a disc keeps the component of its velocity along the next plate, so it loses sin²δ of its
 * kinetic energy. A box w × h meets the next plate with one corner and slides on with a corner on
 * each plate: it keeps the projection of its motion, in the metric of kinetic energy, onto the
 * motion q that both plates allow. With B = cos δ − (h/2w)·sin δ and A = sin²δ·(¼ + (w² + h²)/12w²)
 * it loses A/(A + B²), once for each corner; for small δ the two losses together are δ²(2/3 +
 * h²/6w²).
 */
enum FlatPlateBowl implements Scenes {
    DISC,
    BOX;

    private static final List<Integer> FEW = List.of(12, 90, 1000);
    private static final List<Integer> ALL = List.of(12, 17, 33, 60, 90, 180, 333, 600, 1000);
    private static final double HORIZON = 30;
    private static final int MOST_SWINGS = 10;

    /** The share of its energy at the start below which a body hardly leaves a plate. */
    private static final double LEAST_ENERGY = 0.05;

    /** Limits of the energy's error, as a share of what kinks took and of the start. */
    private static final Limits BY_LOSS = Limits.of(0.03, 0.005);

    private static final Limits BY_START = Limits.of(1e-3, 1e-5);

    @Override
    public void run(Trial trial) {
        for (int plates : trial.sampling().of(FEW, ALL)) {
            double radius = 3 + 4 * trial.sampling().random(plates).nextDouble();
            trial.variant(plates + " lapped plates, bowl of " + radius + " m");
            swing(trial, new PlateBowl(radius, plates, PlateBowl.LAPPED));
            trial.variant(plates + " butted plates, bowl of " + radius + " m");
            swing(trial, new PlateBowl(radius, plates, PlateBowl.BUTTED));
        }
    }

    /** Measures the swings in one bowl. */
    void swing(Trial trial, PlateBowl bowl) {
        int plate = bowl.plateAt(Math.toRadians(-50));
        if (this == DISC) {
            double radius = 0.05 * bowl.radius();
            double loss = Math.pow(Math.sin(bowl.kink()), 2);
            double[] start = bowl.on(plate, 0, radius);
            double[] kinks = bowl.discAtKinks(radius);
            follow(
                    trial,
                    bowl,
                    new Circle(radius),
                    plate,
                    start,
                    new KinkedSlide(kinks, loss, start[1], plate));
        } else {
            double width = Math.min(0.6 * bowl.length(), 0.1 * bowl.radius());
            double height = 0.7 * width;
            double[] start = bowl.on(plate, 0, height / 2);
            double[] kinks = bowl.boxAtKinks(width, height);
            double loss = cornerLoss(bowl.kink(), width, height);
            follow(
                    trial,
                    bowl,
                    Polygon.box(width, height),
                    plate,
                    start,
                    new KinkedSlide(kinks, loss, start[1], 2 * plate));
        }
    }

    /** The share of its kinetic energy that one corner of a box loses at a kink. */
    static double cornerLoss(double kink, double width, double height) {
        double sin = Math.sin(kink);
        double along = Math.cos(kink) - height / (2 * width) * sin;
        double spin = (width * width + height * height) / (12 * width * width);
        double across = sin * sin * (0.25 + spin);
        return across / (across + along * along);
    }

    private static void follow(
            Trial trial,
            PlateBowl bowl,
            Shape shape,
            int plate,
            double[] start,
            KinkedSlide truth) {
        WatchedPool pool = trial.earth().withOverlapOfItsOwn();
        bowl.bodies().forEach(pool::add);
        RigidBody body =
                pool.add(Solid.of(shape, 0, 0).at(start[0], start[1]).angle(bowl.slope(plate)));
        double bottom = -bowl.radius();
        double first = start[1] - bottom;
        List<Double> swings = truth.swings(bottom + LEAST_ENERGY * first, MOST_SWINGS);
        for (double swing : swings) {
            untilItTurns(pool, body);
            double energy = energy(body) - bottom;
            double lost = start[1] - swing;
            double off = Math.abs(energy - (swing - bottom));
            Preset preset = trial.preset();
            double allowed = BY_LOSS.of(preset) * lost + BY_START.of(preset) * first;
            trial.measure("energy off", off / first, "of start", Limits.NONE);
            trial.measure("energy off, by what may be", off / allowed, "times", 1);
        }
        trial.measure("swings missed", isTurning(pool) ? 0 : 1, "swings", 0);
    }

    private static boolean isTurning(WatchedPool pool) {
        return pool.time() < HORIZON;
    }

    private static void untilItTurns(WatchedPool pool, RigidBody body) {
        pool.step();
        double sign = Math.signum(body.velocityX());
        while (body.velocityX() * sign > 0 && pool.time() < HORIZON) {
            pool.step();
        }
    }

    /** Kinetic and potential energy of a body, as a height in m. */
    private static double energy(RigidBody body) {
        return body.y() + body.kineticEnergy() / (body.mass() * Trial.GRAVITY);
    }
}
