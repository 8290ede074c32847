package rigibo.backend.flight;

import rigibo.backend.collision.Motion;
import rigibo.backend.collision.Pose;
import rigibo.backend.force.ChangingForces;
import rigibo.backend.force.Instant;
import rigibo.backend.setup.Integrator;
import rigibo.backend.storage.Bodies;

/**
 * How far forces that change along the way take a body from a reference that is known exactly. With
 * {@code BALLISTIC} the reference is the body's path without those forces, so that forces which are
 * 0 leave no trace; the deviation is integrated after Runge and Kutta. The other integrators'
 * reference is the straight line, which leaves all accelerations to them.
 */
final class Deviation {

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

    /** What the path has deviated by: m and rad, and the same per second. */
    final Freedoms moved = new Freedoms();

    final Freedoms gained = new Freedoms();

    private final ChangingForces forces;
    private final Integrator method;
    private final boolean isBallistic;

    /** Where nothing turns, an angle asks for no substep and is not looked at. */
    private final boolean turns;

    private final Motion reference = new Motion();
    private final Pose pose = new Pose();
    private final Instant instant = new Instant();

    /** The deviation at the instant that is looked at. */
    private final Freedoms movedThere = new Freedoms();

    private final Freedoms gainedThere = new Freedoms();

    /** The rates of a substep's looks: at its start, twice at its middle, at its end. */
    private final Freedoms first = new Freedoms();

    private final Freedoms second = new Freedoms();
    private final Freedoms third = new Freedoms();
    private final Freedoms fourth = new Freedoms();

    /** The accelerations that stay the same, m/s² and rad/s², and the drag in 1/s. */
    private double steadyX;

    private double steadyY;
    private double steadyTurn;
    private double drag;

    /** When the path starts, s since the pool was made. */
    private double start;

    Deviation(ChangingForces forces, Integrator method, boolean turns) {
        this.forces = forces;
        this.turns = turns;
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
     * Integrates over a length in s, with more substeps where the forces are stiff. Where a method
     * that can tell still finds them too long, it begins anew with twice as many.
     */
    void integrate(double length, int substeps) {
        begin();
        int count = Math.max(substeps, substepsByDrag(length));
        while (!isIntegrated(length, count)) {
            begin();
            count *= 2;
        }
    }

    /** Goes back to the path's start and looks there. */
    private void begin() {
        moved.clear();
        gained.clear();
        lookHere(0);
    }

    /**
     * How many substeps of length h keep k·h below 1. Drag changes a force by the share k per
     * second, which a look shortly after the start tells: where a strong drag and another force are
     * in balance, nothing else would tell before the balance is lost. The start has been looked at.
     */
    private int substepsByDrag(double length) {
        if (method == Integrator.EULER || method == Integrator.VERLET) {
            return 1;
        }
        goAhead(SMALL_CHANGE * length, first, 0, first);
        look(0, second);
        double squared = shareOf(second.squaredChange(first), first.squaredPlace());
        if (turns) {
            double turning = shareOf(square(second.turn - first.turn), square(first.turn));
            squared = Math.max(squared, turning);
        }
        return (int) Math.min(MOST_SUBSTEPS, Math.ceil(Math.sqrt(squared) / SMALL_CHANGE));
    }

    private static double shareOf(double changes, double rates) {
        return rates > 0 ? changes / rates : 0;
    }

    /** Goes all substeps from the start, which has been looked at. */
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

    /** Goes one substep from where it was looked, unless it is found too long. */
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

    /** Kutta's method of 1901 for x″ = f(x, x′, t). */
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
     * Compares the two looks at the middle. Between them the velocity moved by h/2 times the change
     * from the first look, and the place by h²/4 times the rate: they differ by (kh/2)² or (ωh/2)²
     * of the rate.
     */
    private boolean isShortEnough() {
        double most = square(MOST_CHANGE);
        double rates = Math.max(first.squaredPlace(), second.squaredPlace());
        boolean isTooLong = third.squaredChange(second) > most * rates;
        if (turns) {
            double turning = Math.max(square(first.turn), square(second.turn));
            isTooLong |= square(third.turn - second.turn) > most * turning;
        }
        return !isTooLong;
    }

    private static double square(double value) {
        return value * value;
    }

    /** Of first order, but no rate, however stiff, does more than undo what it acts against. */
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

    /** The inverse of how many times over a full substep of a rate would undo the rate. */
    private static double shareThatBrakes(double squared, double undone) {
        return undone > squared ? squared / undone : 1;
    }

    /** Looks from where the deviation has come to, at a time in s since the path's start. */
    private void lookHere(double time) {
        movedThere.set(moved);
        gainedThere.set(gained);
        look(time, first);
    }

    /**
     * Lets the deviation that is looked at go ahead of the one reached: for {@code ahead} seconds
     * with its velocity and with a rate, and {@code square} s² times another.
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

    /** Writes the rates at a time in s since the path's start. */
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
