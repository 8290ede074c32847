package rigibo.backend.flight;

import rigibo.backend.force.ChangingForces;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Quarantine;
import rigibo.backend.storage.Roster;

/**
 * The paths of bodies under forces that vary along the path. The effect of such forces up to the
 * end of a path is integrated in substeps. Then a path of constant acceleration is laid that ends
 * at the same place, since the search for impacts needs a path with known bounds. The error of its
 * end velocity is added at the end of the path: for an acceleration that grows by j per second it
 * is j·T²/6 after T seconds. Places along the path are off by at most j·T³/40.
 */
public final class Course {

    private final DataStorage data;
    private final Bodies bodies;
    private final int substeps;
    private final Deviation deviation;

    /** By body: start of its path, s after the step's start. */
    private double[] from = new double[16];

    /** By body: end of its path, s after the step's start. */
    private double[] to = new double[16];

    /** By body: velocity that the laid path lacks at its end, m/s. */
    private double[] lackX = new double[16];

    private double[] lackY = new double[16];

    /** Turning on the paths; null without rotation. */
    private final TurningCourse turning;

    /** Paths under the given forces, integrated at an accuracy. */
    public Course(DataStorage data, ChangingForces forces, Accuracy accuracy) {
        this.data = data;
        bodies = data.bodies;
        substeps = accuracy.substeps();
        deviation = new Deviation(forces, accuracy.integrator(), bodies.turns());
        turning = bodies.turns() ? new TurningCourse(bodies, deviation) : null;
    }

    /** Lays the path of every awake dynamic body through a step of {@code dt} seconds. */
    public void begin(double dt) {
        reserve(bodies.type.length);
        Roster roster = data.roster;
        if (turning != null) {
            turning.begin(roster);
        }
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDynamic(slot)) {
                bodies.pullX[slot] = 0;
                bodies.pullY[slot] = 0;
                if (!isLaid(slot, 0, dt)) {
                    // The report stage of this step will find the body and put it to rest.
                    bodies.accelerationX[slot] = Double.NaN;
                }
            }
        }
    }

    private void reserve(int capacity) {
        if (from.length < capacity) {
            from = new double[capacity];
            to = new double[capacity];
            lackX = new double[capacity];
            lackY = new double[capacity];
        }
    }

    /**
     * Lays a body's path between two times, s after the step's start; its columns hold its state at
     * the first one. If its forces are not finite, the body keeps its old path until the next step.
     */
    void lay(int slot, double begin, double end) {
        isLaid(slot, begin, end);
    }

    /** Lays a path as {@link #lay} does; returns whether it is within bounds. */
    private boolean isLaid(int slot, double begin, double end) {
        from[slot] = begin;
        to[slot] = end;
        lackX[slot] = 0;
        lackY[slot] = 0;
        if (turning != null) {
            turning.forget(slot);
        }
        double length = end - begin;
        if (length <= 0) {
            return true;
        }
        deviation.of(bodies, slot, data.time + begin);
        deviation.integrate(length, substeps);
        if (!isBounded(length)) {
            return false;
        }
        write(slot, length);
        return true;
    }

    /** Whether the path and its end velocity are within the bounds that impact searches need. */
    private boolean isBounded(double length) {
        return deviation.moved.isWithin(Quarantine.FASTEST * length)
                && deviation.gained.isWithin(Quarantine.FASTEST);
    }

    /**
     * Writes the acceleration of the path. By x₁ = x₀ + v₀·E₁ + a·E₂, a deviation d of the end
     * place needs the acceleration d/E₂, added to the one of the reference path.
     */
    private void write(int slot, double length) {
        double e1 = deviation.velocityShare(length);
        double e2 = deviation.accelerationShare(length);
        double ax = deviation.moved.x / e2;
        double ay = deviation.moved.y / e2;
        bodies.accelerationX[slot] = deviation.keepingX() + ax;
        bodies.accelerationY[slot] = deviation.keepingY() + ay;
        bodies.pullX[slot] = deviation.keepingX() - deviation.steadyX() + ax;
        bodies.pullY[slot] = deviation.keepingY() - deviation.steadyY() + ay;
        lackX[slot] = deviation.gained.x - ax * e1;
        lackY[slot] = deviation.gained.y - ay * e1;
        if (turning != null) {
            turning.write(slot, length);
        }
    }

    /**
     * Corrects the velocity of a body whose columns were advanced to a time on its path. After a
     * share σ of the path it gets σ(3σ − 2) of the velocity that the path lacks at its end, as on
     * the cubic with the same ends.
     */
    void catchUp(int slot, double time) {
        boolean lacksSpin = turning != null && turning.lacksSpin(slot);
        if (lackX[slot] == 0 && lackY[slot] == 0 && !lacksSpin) {
            return;
        }
        double gone = (time - from[slot]) / (to[slot] - from[slot]);
        double share = gone * (3 * gone - 2);
        bodies.velocityX[slot] += share * lackX[slot];
        bodies.velocityY[slot] += share * lackY[slot];
        lackX[slot] = 0;
        lackY[slot] = 0;
        if (turning != null) {
            turning.catchUp(slot, share);
        }
    }
}
