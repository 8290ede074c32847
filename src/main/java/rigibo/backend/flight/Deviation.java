package rigibo.backend.flight;

import rigibo.backend.collision.Motion;
import rigibo.backend.collision.Pose;
import rigibo.backend.force.ChangingForces;
import rigibo.backend.force.Instant;
import rigibo.backend.setup.Integrator;
import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * How far forces that change along the way take a body from a reference that is known exactly. With
 * {@code BALLISTIC} the reference is the body's path without those forces, so that forces which are
 * 0 leave no trace; the deviation is integrated after Runge and Kutta. The other integrators'
 * reference is the straight line, which leaves all accelerations to them.
 */
final class Deviation {

    /** x, y and, where bodies turn, the angle; the first two belong together. */
    static final int FREEDOMS = 3;

    private static final int LINEAR = 2;

    /**
     * Change of a rate between the two looks at a substep's middle, as a share of the rate, beyond
     * which a substep is too long: at a quarter ω·h or k·h is 1, and an explicit method overshoots
     * from 2.8 on.
     */
    private static final double MOST_CHANGE = 0.25;

    /** Share of a path's length for which a rate is followed to see how it changes. */
    private static final double SMALL_CHANGE = 1e-3;

    /** Substeps of a path at most; what is too stiff for them is braked without overshooting. */
    private static final int MOST_SUBSTEPS = 1024;

    /** What the path has deviated by: m, m and rad, and the same per second. */
    final double[] moved = new double[FREEDOMS];

    final double[] gained = new double[FREEDOMS];

    private final ChangingForces forces;
    private final Integrator method;
    private final boolean isBallistic;

    /** How many of the freedoms there are: where nothing turns, an angle asks for no substep. */
    private final int freedoms;

    private final Motion reference = new Motion();
    private final Pose pose = new Pose();
    private final Instant instant = new Instant();

    /** The deviation at the instant that is looked at, and the rates of the looks so far. */
    private final double[] movedThere = new double[FREEDOMS];

    private final double[] gainedThere = new double[FREEDOMS];
    private final double[][] rate = new double[4][FREEDOMS];

    /** The accelerations that stay the same, m/s² and rad/s², and the drag in 1/s. */
    private double steadyX;

    private double steadyY;
    private double steadyTurn;
    private double drag;

    /** When the path starts, s since the pool was made. */
    private double start;

    Deviation(ChangingForces forces, Integrator method, boolean turns) {
        this.forces = forces;
        freedoms = turns ? FREEDOMS : LINEAR;
        this.method = method;
        isBallistic = method == Integrator.BALLISTIC;
    }

    /** Takes a body at a time in s since the pool was made, at which its columns hold. */
    void of(Bodies bodies, int slot, double time) {
        start = time;
        instant.take(bodies, slot);
        drag = instant.drag;
        steadyX = bodies.accelerationX[slot] - bodies.pullX[slot];
        steadyY = bodies.accelerationY[slot] - bodies.pullY[slot];
        reference.x = bodies.x[slot];
        reference.y = bodies.y[slot];
        reference.angle = bodies.angle[slot];
        reference.velocityX = bodies.velocityX[slot];
        reference.velocityY = bodies.velocityY[slot];
        reference.drag = isBallistic ? drag : 0;
        reference.accelerationX = isBallistic ? steadyX : 0;
        reference.accelerationY = isBallistic ? steadyY : 0;
        if (freedoms > LINEAR) {
            takeTurning(bodies, slot);
        }
    }

    private void takeTurning(Bodies bodies, int slot) {
        steadyTurn = bodies.angularAcceleration[slot] - bodies.pullTurn[slot];
        reference.spin = bodies.spin[slot];
        reference.angularAcceleration = isBallistic ? steadyTurn : 0;
    }

    /**
     * Integrates over a length in s, with more substeps where the forces are stiff. Where a method
     * that can tell still finds them too long, it begins anew with twice as many.
     */
    void integrate(double length, int substeps) {
        int count = Math.max(substeps, substepsByDrag(length));
        while (!isIntegrated(length, count)) {
            count *= 2;
        }
    }

    /**
     * How many substeps h keep k·h below 1, with k the share of a force, per second, that a change
     * of velocity along it takes away. Where a strong drag and another force are in balance,
     * nothing else would tell before the balance is lost.
     */
    private int substepsByDrag(double length) {
        if (method == Integrator.EULER || method == Integrator.VERLET) {
            return 1;
        }
        Arrays.fill(moved, 0);
        Arrays.fill(gained, 0);
        look(0, 0, 0, 0);
        look(1, 0, SMALL_CHANGE * length, 0);
        double squared = Math.max(squaredDrag(0, LINEAR), squaredDrag(LINEAR, freedoms));
        return (int) Math.min(MOST_SUBSTEPS, Math.ceil(Math.sqrt(squared) / SMALL_CHANGE));
    }

    /** The square of the share of the first look's rate by which the second one's differs. */
    private double squaredDrag(int first, int end) {
        double rates = 0;
        double changes = 0;
        for (int i = first; i < end; i++) {
            rates += square(rate[0][i]);
            changes += square(rate[1][i] - rate[0][i]);
        }
        return rates > 0 ? changes / rates : 0;
    }

    private boolean isIntegrated(double length, int count) {
        Arrays.fill(moved, 0);
        Arrays.fill(gained, 0);
        double h = length / count;
        for (int i = 0; i < count; i++) {
            if (!step(i * h, h)) {
                if (count < MOST_SUBSTEPS) {
                    return false;
                }
                brake(i * h, h);
            }
        }
        return true;
    }

    /** Goes one substep, unless it is found too long. */
    private boolean step(double time, double h) {
        return switch (method) {
            case EULER -> stepByEuler(time, h);
            case VERLET -> stepByVerlet(time, h);
            case RK4, BALLISTIC -> stepByRungeKutta(time, h);
        };
    }

    private boolean stepByEuler(double time, double h) {
        look(0, time, 0, 0);
        for (int i = 0; i < freedoms; i++) {
            gained[i] += h * rate[0][i];
            moved[i] += h * gained[i];
        }
        return true;
    }

    private boolean stepByVerlet(double time, double h) {
        look(0, time, 0, 0);
        look(1, time + h, h, h * h / 2);
        for (int i = 0; i < freedoms; i++) {
            moved[i] += h * (gained[i] + h / 2 * rate[0][i]);
            gained[i] += h / 2 * (rate[0][i] + rate[1][i]);
        }
        return true;
    }

    /** Kutta's method of 1901 for x″ = f(x, x′, t). */
    private boolean stepByRungeKutta(double time, double h) {
        double half = h / 2;
        look(0, time, 0, 0);
        look(1, time + half, half, 0);
        look(2, time + half, half, half * half);
        look(3, time + h, h, h * half);
        if (!isShortEnough(0, LINEAR) || !isShortEnough(LINEAR, freedoms)) {
            return false;
        }
        for (int i = 0; i < freedoms; i++) {
            double middle = rate[1][i] + rate[2][i];
            moved[i] += h * (gained[i] + h / 6 * (rate[0][i] + middle));
            gained[i] += h / 6 * (rate[0][i] + 2 * middle + rate[3][i]);
        }
        return true;
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
        return !(change > square(MOST_CHANGE) * Math.max(before, middle));
    }

    private static double square(double value) {
        return value * value;
    }

    /** Of first order, but no rate, however stiff, does more than undo what it acts against. */
    private void brake(double time, double h) {
        look(0, time, 0, 0);
        look(1, time + h, h, 0);
        double linear = shareThatBrakes(0, LINEAR);
        double angular = shareThatBrakes(LINEAR, freedoms);
        for (int i = 0; i < freedoms; i++) {
            gained[i] += (i < LINEAR ? linear : angular) * h * rate[0][i];
            moved[i] += h * gained[i];
        }
    }

    /** The inverse of how many times over a full substep of a rate would undo the rate. */
    private double shareThatBrakes(int first, int end) {
        double squared = 0;
        double undone = 0;
        for (int i = first; i < end; i++) {
            squared += square(rate[0][i]);
            undone += rate[0][i] * (rate[0][i] - rate[1][i]);
        }
        return undone > squared ? squared / undone : 1;
    }

    /**
     * Writes the rates at a time in s since the path's start, for a deviation that has gone ahead
     * from the substep's start: for {@code ahead} seconds with its velocity and with the rates of
     * the look before, and {@code square} s² times those of the look before that.
     */
    private void look(int number, double time, double ahead, double square) {
        double[] kicking = rate[Math.max(0, number - 1)];
        double[] pulling = rate[Math.max(0, number - 2)];
        for (int i = 0; i < freedoms; i++) {
            movedThere[i] =
                    ahead == 0 ? moved[i] : moved[i] + (ahead * gained[i] + square * pulling[i]);
            gainedThere[i] = ahead == 0 ? gained[i] : gained[i] + ahead * kicking[i];
        }
        takePlace(time);
        forces.evaluate(instant);
        double[] out = rate[number];
        if (isBallistic) {
            out[0] = instant.accelerationX - drag * gainedThere[0];
            out[1] = instant.accelerationY - drag * gainedThere[1];
            out[2] = instant.angularAcceleration;
        } else {
            out[0] = instant.accelerationX + (steadyX - drag * instant.velocityX);
            out[1] = instant.accelerationY + (steadyY - drag * instant.velocityY);
            out[2] = instant.angularAcceleration + steadyTurn;
        }
    }

    private void takePlace(double time) {
        reference.placeAt(time, pose);
        instant.time = start + time;
        instant.x = pose.x + movedThere[0];
        instant.y = pose.y + movedThere[1];
        instant.angle = reference.angleAt(time) + movedThere[2];
        instant.velocityX = reference.velocityXAt(time) + gainedThere[0];
        instant.velocityY = reference.velocityYAt(time) + gainedThere[1];
        instant.spin = reference.spinAt(time) + gainedThere[2];
    }

    /** E₁ and E₂ of the path's own drag, after a length in s. */
    double velocityShare(double length) {
        reference.drag = drag;
        return reference.velocityShare(length);
    }

    double accelerationShare(double length) {
        reference.drag = drag;
        return reference.accelerationShare(length, reference.velocityShare(length));
    }

    /**
     * The constant acceleration that keeps a path with drag on the reference: the steady one, or
     * what holds up the straight line, k·v.
     */
    double keepingX() {
        return isBallistic ? steadyX : drag * reference.velocityX;
    }

    double keepingY() {
        return isBallistic ? steadyY : drag * reference.velocityY;
    }

    double keepingTurn() {
        return isBallistic ? steadyTurn : 0;
    }

    double steadyX() {
        return steadyX;
    }

    double steadyY() {
        return steadyY;
    }

    double steadyTurn() {
        return steadyTurn;
    }
}
