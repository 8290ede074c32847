package rigibo.backend.flight;

import rigibo.backend.collision.Motion;
import rigibo.backend.collision.Pose;
import rigibo.backend.force.ChangingForces;
import rigibo.backend.force.Instant;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.Integrator;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Roster;

import java.util.Arrays;

/**
 * The paths of bodies under forces that change along the way. A path is integrated in substeps as
 * its deviation from a reference that is known exactly; what comes of it is laid as one path of
 * constant acceleration that ends in the same place, so that impacts are searched on a path with
 * certain bounds. What its velocity then lacks is added at the path's end: for a force that changes
 * by j per second, j·T²/6 after T seconds, and meanwhile no place is off by more than j·T³/40.
 *
 * <p>With {@code BALLISTIC} the reference is the body's exact path without the changing forces, so
 * that forces which are 0 leave every bit as it was; the deviation is integrated after Runge and
 * Kutta. The other integrators' reference is the straight line, which leaves everything to them.
 */
public final class Course {

    /** x, y and angle. */
    private static final int FREEDOMS = 3;

    /**
     * Change of a rate between the two looks at a substep's middle, as a share of the rate, beyond
     * which a substep is too long: at a quarter ω·h or k·h is 1, and an explicit method overshoots
     * from 2.8 on.
     */
    private static final double MOST_CHANGE = 0.25;

    /** Substeps of a path at most; a force too stiff for them is the caller's to soften. */
    private static final int MOST_SUBSTEPS = 1024;

    private final DataStorage data;
    private final Bodies bodies;
    private final ChangingForces forces;
    private final Integrator method;
    private final int substeps;

    private final Motion reference = new Motion();
    private final Pose pose = new Pose();
    private final Instant instant = new Instant();

    /** What the path has deviated from the reference, in place and in velocity. */
    private final double[] moved = new double[FREEDOMS];

    private final double[] gained = new double[FREEDOMS];

    /** Where a rate is asked for, likewise, and the rates at the places of a substep. */
    private final double[] movedThere = new double[FREEDOMS];

    private final double[] gainedThere = new double[FREEDOMS];
    private final double[][] rate = new double[4][FREEDOMS];

    /** The time the path starts at, s after the step's start. */
    private double start;

    /** The accelerations that are the same all along, m/s². */
    private double steadyX;

    private double steadyY;
    private double steadyTurn;

    /** Per body: when its path starts and ends, s after the step's start, and what it lacks. */
    private double[] from = new double[16];

    private double[] to = new double[16];
    private double[] lackX = new double[16];
    private double[] lackY = new double[16];
    private double[] lackSpin = new double[16];

    /** Paths under these forces at an accuracy. */
    public Course(DataStorage data, ChangingForces forces, Accuracy accuracy) {
        this.data = data;
        this.forces = forces;
        bodies = data.bodies;
        method = accuracy.integrator();
        substeps = accuracy.substeps();
    }

    /** Lays the path of every awake dynamic body through a step of {@code dt} seconds. */
    public void begin(double dt) {
        reserve(bodies.type.length);
        Roster roster = data.roster;
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDynamic(slot)) {
                bodies.pullX[slot] = 0;
                bodies.pullY[slot] = 0;
                bodies.pullTurn[slot] = 0;
                lay(slot, 0, dt);
            }
        }
    }

    private void reserve(int capacity) {
        if (from.length < capacity) {
            from = new double[capacity];
            to = new double[capacity];
            lackX = new double[capacity];
            lackY = new double[capacity];
            lackSpin = new double[capacity];
        }
    }

    /** Lays a body's path from a time, at which its columns hold, to a later one. */
    void lay(int slot, double begin, double end) {
        from[slot] = begin;
        to[slot] = end;
        lackX[slot] = 0;
        lackY[slot] = 0;
        lackSpin[slot] = 0;
        double length = end - begin;
        if (!(length > 0)) {
            return;
        }
        takeUp(slot, begin);
        int count = substeps;
        while (!integrate(length, count) && count < MOST_SUBSTEPS) {
            count *= 2;
        }
        write(slot, length);
    }

    private void takeUp(int slot, double begin) {
        start = begin;
        steadyX = bodies.accelerationX[slot] - bodies.pullX[slot];
        steadyY = bodies.accelerationY[slot] - bodies.pullY[slot];
        steadyTurn = bodies.angularAcceleration[slot] - bodies.pullTurn[slot];
        instant.take(bodies, slot);
        reference.x = bodies.x[slot];
        reference.y = bodies.y[slot];
        reference.angle = bodies.angle[slot];
        reference.velocityX = bodies.velocityX[slot];
        reference.velocityY = bodies.velocityY[slot];
        reference.spin = bodies.spin[slot];
        boolean isBallistic = method == Integrator.BALLISTIC;
        reference.drag = isBallistic ? instant.drag : 0;
        reference.accelerationX = isBallistic ? steadyX : 0;
        reference.accelerationY = isBallistic ? steadyY : 0;
        reference.angularAcceleration = isBallistic ? steadyTurn : 0;
    }

    /** Integrates the deviation over a length in s; false where the substeps were too long. */
    private boolean integrate(double length, int count) {
        Arrays.fill(moved, 0);
        Arrays.fill(gained, 0);
        double h = length / count;
        boolean isFine = true;
        for (int i = 0; i < count && isFine; i++) {
            double time = i * h;
            switch (method) {
                case EULER:
                    stepByEuler(time, h);
                    break;
                case VERLET:
                    stepByVerlet(time, h);
                    break;
                default:
                    isFine = stepByRungeKutta(time, h) || count >= MOST_SUBSTEPS;
                    break;
            }
        }
        return isFine;
    }

    private void stepByEuler(double time, double h) {
        look(rate[0], time, 0, 0, rate[0], 0, rate[0]);
        for (int i = 0; i < FREEDOMS; i++) {
            gained[i] += h * rate[0][i];
            moved[i] += h * gained[i];
        }
    }

    private void stepByVerlet(double time, double h) {
        look(rate[0], time, 0, 0, rate[0], 0, rate[0]);
        look(rate[1], time + h, h, h * h / 2, rate[0], h, rate[0]);
        for (int i = 0; i < FREEDOMS; i++) {
            moved[i] += h * (gained[i] + h / 2 * rate[0][i]);
            gained[i] += h / 2 * (rate[0][i] + rate[1][i]);
        }
    }

    /** Kutta's method of 1901 for x″ = f(x, x′, t); false where the substep is too long. */
    private boolean stepByRungeKutta(double time, double h) {
        double half = h / 2;
        look(rate[0], time, 0, 0, rate[0], 0, rate[0]);
        look(rate[1], time + half, half, 0, rate[0], half, rate[0]);
        look(rate[2], time + half, half, half * half, rate[0], half, rate[1]);
        look(rate[3], time + h, h, h * half, rate[1], h, rate[2]);
        for (int i = 0; i < FREEDOMS; i++) {
            double middle = rate[1][i] + rate[2][i];
            moved[i] += h * (gained[i] + h / 6 * (rate[0][i] + middle));
            gained[i] += h / 6 * (rate[0][i] + 2 * middle + rate[3][i]);
        }
        return isShortEnough(0, 2) && isShortEnough(2, FREEDOMS);
    }

    /**
     * The rate of the deviation's velocity at a time since the path's start, for a deviation that
     * has gone on at its velocity for {@code drift} seconds, {@code square} s² times one rate
     * farther, and gained {@code kick} seconds of another.
     */
    private void look(
            double[] out,
            double time,
            double drift,
            double square,
            double[] pulling,
            double kick,
            double[] kicking) {
        for (int i = 0; i < FREEDOMS; i++) {
            movedThere[i] = moved[i] + (drift * gained[i] + square * pulling[i]);
            gainedThere[i] = gained[i] + kick * kicking[i];
        }
        reference.placeAt(time, pose);
        double vx = reference.velocityXAt(time);
        double vy = reference.velocityYAt(time);
        instant.time = data.time + start + time;
        instant.x = pose.x + movedThere[0];
        instant.y = pose.y + movedThere[1];
        instant.angle = reference.angleAt(time) + movedThere[2];
        instant.velocityX = vx + gainedThere[0];
        instant.velocityY = vy + gainedThere[1];
        instant.spin = reference.spinAt(time) + gainedThere[2];
        forces.evaluate(instant);
        boolean isBallistic = method == Integrator.BALLISTIC;
        double k = instant.drag;
        out[0] =
                instant.accelerationX
                        + (isBallistic ? -k * gainedThere[0] : steadyX - k * instant.velocityX);
        out[1] =
                instant.accelerationY
                        + (isBallistic ? -k * gainedThere[1] : steadyY - k * instant.velocityY);
        out[2] = instant.angularAcceleration + (isBallistic ? 0 : steadyTurn);
    }

    /**
     * Compares the two looks at the middle. Between them the velocity moved by h/2 times the change
     * from the first look, and the place by h²/4 times the rate: they differ by (kh/2)² or (ωh/2)²
     * of the rate.
     */
    private boolean isShortEnough(int first, int end) {
        double change = 0;
        double before = 0;
        double middle = 0;
        for (int i = first; i < end; i++) {
            change += square(rate[2][i] - rate[1][i]);
            before += square(rate[0][i]);
            middle += square(rate[1][i]);
        }
        return !(change > MOST_CHANGE * MOST_CHANGE * Math.max(before, middle));
    }

    private static double square(double value) {
        return value * value;
    }

    /** Lays the path that ends where the integration does, and notes what its velocity lacks. */
    private void write(int slot, double length) {
        boolean isBallistic = method == Integrator.BALLISTIC;
        double k = instant.drag;
        reference.drag = k;
        double e1 = reference.velocityShare(length);
        double e2 = reference.accelerationShare(length, e1);
        double ax = moved[0] / e2;
        double ay = moved[1] / e2;
        double turn = moved[2] / (length * length / 2);
        double sum = ax + ay + turn + gained[0] + gained[1] + gained[2];
        if (!(Math.abs(sum) < Double.POSITIVE_INFINITY)) {
            spoil(slot);
            return;
        }
        double pathX = ax + (isBallistic ? steadyX : k * reference.velocityX);
        double pathY = ay + (isBallistic ? steadyY : k * reference.velocityY);
        double pathTurn = turn + (isBallistic ? steadyTurn : 0);
        bodies.pullX[slot] = isBallistic ? ax : pathX - steadyX;
        bodies.pullY[slot] = isBallistic ? ay : pathY - steadyY;
        bodies.pullTurn[slot] = isBallistic ? turn : pathTurn - steadyTurn;
        bodies.accelerationX[slot] = pathX;
        bodies.accelerationY[slot] = pathY;
        bodies.angularAcceleration[slot] = pathTurn;
        lackX[slot] = gained[0] - ax * e1;
        lackY[slot] = gained[1] - ay * e1;
        lackSpin[slot] = gained[2] - turn * length;
    }

    /**
     * A force that is not finite: at the step's start it puts its body to rest, as the ledger sees
     * to; within the step the body goes on as it was.
     */
    private void spoil(int slot) {
        if (start == 0) {
            bodies.accelerationX[slot] = Double.NaN;
        }
    }

    /**
     * Gives a body, whose columns were brought to a time on its path, the velocity it has there: of
     * what the path lacks at its end, σ(3σ − 2) after the share σ of its length, as on the cubic
     * that has both ends in common with it.
     */
    void catchUp(int slot, double time) {
        if (lackX[slot] == 0 && lackY[slot] == 0 && lackSpin[slot] == 0) {
            return;
        }
        double gone = (time - from[slot]) / (to[slot] - from[slot]);
        double share = gone * (3 * gone - 2);
        bodies.velocityX[slot] += share * lackX[slot];
        bodies.velocityY[slot] += share * lackY[slot];
        bodies.spin[slot] += share * lackSpin[slot];
        lackX[slot] = 0;
        lackY[slot] = 0;
        lackSpin[slot] = 0;
    }
}
