package rigibo.backend.flight;

import rigibo.backend.collision.distance.Motion;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.force.ChangingForces;
import rigibo.backend.force.Instant;
import rigibo.backend.setup.Integrator;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.RoundOff;

/**
 * The deviation of a body, caused by forces that vary along the path, from an exactly known
 * reference path. With {@code BALLISTIC} the reference is the path without those forces, so that a
 * force of 0 causes no error at all, and the deviation is integrated by Runge–Kutta. With the other
 * integrators the reference is the straight line, so that they integrate all accelerations.
 */
final class Deviation {

    /**
     * Largest change between the two evaluations at a substep's middle, as a share of the rate;
     * with a larger one the substep is too long. At a quarter, ω·h or k·h is 1; an explicit method
     * overshoots from 2.8 on.
     */
    private static final double MOST_CHANGE = 0.25;

    /** Share of a path's length after which a rate is evaluated again to find how it changes. */
    private static final double SMALL_CHANGE = 1e-3;

    /** Most substeps of a path; stiffer forces are integrated implicitly, without overshooting. */
    private static final int MOST_SUBSTEPS = 1024;

    /** Deviation of the path so far: place in m and rad, then velocity in m/s and rad/s. */
    final Freedoms moved = new Freedoms();

    final Freedoms gained = new Freedoms();

    private final ChangingForces forces;
    private final Integrator method;
    private final boolean isBallistic;

    /** Whether bodies turn; if not, angles are not integrated. */
    private final boolean turns;

    private final Motion reference = new Motion();
    private final Pose pose = new Pose();
    private final Instant instant = new Instant();

    /** Deviation at the time of the present evaluation. */
    private final Freedoms movedThere = new Freedoms();

    private final Freedoms gainedThere = new Freedoms();

    /** Rates k₁ to k₄ of a substep: at its start, twice at its middle, at its end. */
    private final Freedoms first = new Freedoms();

    private final Freedoms second = new Freedoms();
    private final Freedoms third = new Freedoms();
    private final Freedoms fourth = new Freedoms();

    /** Constant accelerations, m/s² and rad/s², and the linear drag, 1/s. */
    private double steadyX;

    private double steadyY;
    private double steadyTurn;
    private double drag;

    /** Changes of the rates that count as round-off, squared: (m/s²)² and (rad/s²)². */
    private double noise;

    private double turningNoise;

    /** Start of the path, s since the pool was made. */
    private double start;

    Deviation(ChangingForces forces, Integrator method, boolean turns) {
        this.forces = forces;
        this.turns = turns;
        this.method = method;
        isBallistic = method == Integrator.BALLISTIC;
    }

    /** Loads a body whose columns hold its state at a time, s since the pool was made. */
    void of(Bodies bodies, int slot, double time) {
        start = time;
        instant.take(bodies, slot);
        drag = instant.drag;
        steadyX = bodies.accelerationX[slot] - bodies.pullX[slot];
        steadyY = bodies.accelerationY[slot] - bodies.pullY[slot];
        reference.x = bodies.x[slot];
        reference.y = bodies.y[slot];
        reference.velocityX = bodies.velocityX[slot];
        reference.velocityY = bodies.velocityY[slot];
        reference.drag = isBallistic ? drag : 0;
        reference.accelerationX = isBallistic ? steadyX : 0;
        reference.accelerationY = isBallistic ? steadyY : 0;
        instant.angle = bodies.angle[slot];
        if (turns) {
            takeTurning(bodies, slot);
        }
    }

    private void takeTurning(Bodies bodies, int slot) {
        steadyTurn = bodies.angularAcceleration[slot] - bodies.pullTurn[slot];
        reference.angle = bodies.angle[slot];
        reference.spin = bodies.spin[slot];
        reference.angularAcceleration = isBallistic ? steadyTurn : 0;
    }

    /**
     * Integrates over a length in s, with more substeps where the forces are stiff. If the method
     * can estimate its error and finds the substeps too long, it starts again with twice as many.
     */
    void integrate(double length, int substeps) {
        begin();
        int count = Math.max(substeps, substepsByDrag(length));
        while (!isIntegrated(length, count)) {
            begin();
            count *= 2;
        }
    }

    /** Resets to the start of the path and evaluates the forces there. */
    private void begin() {
        moved.clear();
        gained.clear();
        lookHere(0);
        double pulls =
                instant.accelerationX * instant.accelerationX
                        + instant.accelerationY * instant.accelerationY;
        // A torque whose terms cancel, such as that of a floating body that does not list, is all
        // round-off: it changes by as much as it is, and would pass for the stiffest of forces.
        noise = square(RoundOff.OF_SUMS) * pulls;
        turningNoise =
                noise * square(instant.boundingRadius * instant.mass * instant.inverseInertia);
    }

    /**
     * Number of substeps of length h that keeps k·h below 1, where k is the relative change of the
     * force per second by drag. A second evaluation shortly after the start measures k, since
     * nothing else shows a strong drag that balances another force. The forces at the start must
     * have been evaluated.
     */
    private int substepsByDrag(double length) {
        if (method == Integrator.EULER || method == Integrator.VERLET) {
            return 1;
        }
        goAhead(SMALL_CHANGE * length, first, 0, first);
        look(0, second);
        double squared = shareOf(second.squaredChange(first) - noise, first.squaredPlace());
        if (turns) {
            double change = square(second.turn - first.turn) - turningNoise;
            double turning = shareOf(change, square(first.turn));
            squared = Math.max(squared, turning);
        }
        return (int) Math.min(MOST_SUBSTEPS, Math.ceil(Math.sqrt(squared) / SMALL_CHANGE));
    }

    private static double shareOf(double changes, double rates) {
        return changes > 0 && rates > 0 ? changes / rates : 0;
    }

    /**
     * Makes all substeps from the start, where the forces have been evaluated; returns false if one
     * is too long.
     */
    private boolean isIntegrated(double length, int count) {
        double h = length / count;
        for (int i = 0; i < count; i++) {
            if (i > 0) {
                lookHere(i * h);
            }
            if (!step(i * h, h)) {
                if (count < MOST_SUBSTEPS) {
                    return false;
                }
                brake(i * h, h);
            }
        }
        return true;
    }

    /** Makes one substep from the last evaluation; returns false if it is too long. */
    private boolean step(double time, double h) {
        return switch (method) {
            case EULER -> stepByEuler(h);
            case VERLET -> stepByVerlet(time, h);
            case RK4, BALLISTIC -> stepByRungeKutta(time, h);
        };
    }

    private boolean stepByEuler(double h) {
        gained.add(h, first);
        moved.add(h, gained);
        return true;
    }

    private boolean stepByVerlet(double time, double h) {
        goAhead(h, first, h * h / 2, first);
        look(time + h, second);
        moved.add(h, gained);
        moved.add(h * (h / 2), first);
        gained.add(h / 2, first);
        gained.add(h / 2, second);
        return true;
    }

    /** Kutta's method of 1901 for x″ = f(x, x′, t); returns false if the substep is too long. */
    private boolean stepByRungeKutta(double time, double h) {
        double half = h / 2;
        goAhead(half, first, 0, first);
        look(time + half, second);
        goAhead(half, second, half * half, first);
        look(time + half, third);
        goAhead(h, third, h * half, second);
        look(time + h, fourth);
        if (!isShortEnough()) {
            return false;
        }
        double sixth = h / 6;
        moved.x += h * (gained.x + sixth * (first.x + (second.x + third.x)));
        moved.y += h * (gained.y + sixth * (first.y + (second.y + third.y)));
        gained.x += sixth * (first.x + 2 * (second.x + third.x) + fourth.x);
        gained.y += sixth * (first.y + 2 * (second.y + third.y) + fourth.y);
        if (turns) {
            moved.turn += h * (gained.turn + sixth * (first.turn + (second.turn + third.turn)));
            gained.turn += sixth * (first.turn + 2 * (second.turn + third.turn) + fourth.turn);
        }
        return true;
    }

    /**
     * Whether the two evaluations at the middle agree well enough. Between them the velocity
     * differs by h/2 times the change of the first rate, and the place by h²/4 times the rate, so
     * the rates differ by (kh/2)² or (ωh/2)² of their size.
     */
    private boolean isShortEnough() {
        double most = square(MOST_CHANGE);
        double rates = Math.max(first.squaredPlace(), second.squaredPlace());
        boolean isTooLong = third.squaredChange(second) > most * rates + noise;
        if (turns) {
            double turning = Math.max(square(first.turn), square(second.turn));
            isTooLong |= square(third.turn - second.turn) > most * turning + turningNoise;
        }
        return !isTooLong;
    }

    private static double square(double value) {
        return value * value;
    }

    /** A first-order substep in which no rate, however stiff, overshoots its equilibrium. */
    private void brake(double time, double h) {
        goAhead(h, first, 0, first);
        look(time + h, second);
        double undone = first.x * (first.x - second.x) + first.y * (first.y - second.y);
        double linear = shareThatBrakes(first.squaredPlace(), undone);
        gained.x += linear * h * first.x;
        gained.y += linear * h * first.y;
        if (turns) {
            double unturned = first.turn * (first.turn - second.turn);
            gained.turn += shareThatBrakes(square(first.turn), unturned) * h * first.turn;
        }
        moved.add(h, gained);
    }

    /** Share of a substep's rate that is applied, so that it does not overshoot. */
    private static double shareThatBrakes(double squared, double undone) {
        return undone > squared ? squared / undone : 1;
    }

    /** Evaluates the rates at the present deviation and a time, s since the path's start. */
    private void lookHere(double time) {
        movedThere.set(moved);
        gainedThere.set(gained);
        look(time, first);
    }

    /**
     * Sets the deviation of the next evaluation ahead of the present one: {@code ahead} seconds on
     * by its velocity and the rate {@code kicking}, plus {@code square} s² times {@code pulling}.
     */
    private void goAhead(double ahead, Freedoms kicking, double square, Freedoms pulling) {
        movedThere.x = moved.x + (ahead * gained.x + square * pulling.x);
        movedThere.y = moved.y + (ahead * gained.y + square * pulling.y);
        gainedThere.x = gained.x + ahead * kicking.x;
        gainedThere.y = gained.y + ahead * kicking.y;
        if (turns) {
            movedThere.turn = moved.turn + (ahead * gained.turn + square * pulling.turn);
            gainedThere.turn = gained.turn + ahead * kicking.turn;
        }
    }

    /** Evaluates the forces at a time, s since the path's start, and writes the rates. */
    private void look(double time, Freedoms out) {
        takePlace(time);
        if (turns) {
            takeTurn(time);
        }
        forces.evaluate(instant);
        if (isBallistic) {
            out.x = instant.accelerationX - drag * gainedThere.x;
            out.y = instant.accelerationY - drag * gainedThere.y;
            out.turn = instant.angularAcceleration;
        } else {
            out.x = instant.accelerationX + (steadyX - drag * instant.velocityX);
            out.y = instant.accelerationY + (steadyY - drag * instant.velocityY);
            out.turn = instant.angularAcceleration + steadyTurn;
        }
    }

    private void takePlace(double time) {
        instant.time = start + time;
        reference.placeAt(time, pose);
        instant.x = pose.x + movedThere.x;
        instant.y = pose.y + movedThere.y;
        instant.velocityX = reference.velocityXAt(time) + gainedThere.x;
        instant.velocityY = reference.velocityYAt(time) + gainedThere.y;
    }

    private void takeTurn(double time) {
        instant.angle = reference.angleAt(time) + movedThere.turn;
        instant.spin = reference.spinAt(time) + gainedThere.turn;
    }

    /** E₁ of the path's linear drag after a length in s. */
    double velocityShare(double length) {
        reference.drag = drag;
        return reference.velocityShare(length);
    }

    double accelerationShare(double length) {
        reference.drag = drag;
        return reference.accelerationShare(length, reference.velocityShare(length));
    }

    /**
     * The constant acceleration that keeps a path with drag on the reference: for {@code BALLISTIC}
     * the steady one, otherwise k·v, which keeps the line straight.
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
