package rigibo.backend.flight;

import rigibo.backend.force.ChangingForces;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Quarantine;
import rigibo.backend.storage.Roster;

/**
 * The paths of bodies under forces that change along the way. What such forces do until a path's
 * end is integrated in substeps; then one path of constant acceleration is laid that ends in the
 * same place, so that impacts are searched on a path with certain bounds. What its velocity lacks
 * there is added at the end: for a force that grows by j per second, j·T²/6 after T seconds. On the
 * way no place is off by more than j·T³/40.
 */
public final class Course {

    private final DataStorage data;
    private final Bodies bodies;
    private final int substeps;
    private final Deviation deviation;

    /** Per body: when its path starts and ends, s after the step's start. */
    private double[] from = new double[16];

    private double[] to = new double[16];

    /** Per body: what the velocity lacks at the path's end, m/s. */
    private double[] lackX = new double[16];

    private double[] lackY = new double[16];

    /** The same of turning, or null where nothing turns. */
    private final TurningCourse turning;

    /** Paths under these forces at an accuracy. */
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
                    // The report of the step, which looks next, puts it to rest.
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
     * Lays a body's path between two times in s after the step's start; its columns hold at the
     * first. Where its forces are beyond all bounds it goes on as before until the next step.
     */
    void lay(int slot, double begin, double end) {
        isLaid(slot, begin, end);
    }

    /** The same; returns whether the path is within bounds. */
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

    /** Whether the path, and the velocity it leads to, are such that bodies can meet on it. */
    private boolean isBounded(double length) {
        return deviation.moved.isWithin(Quarantine.FASTEST * length)
                && deviation.gained.isWithin(Quarantine.FASTEST);
    }

    /**
     * From x₁ = x₀ + v₀·E₁ + a·E₂: a deviation d of place takes the acceleration d/E₂ beside the
     * one that keeps to the reference.
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
     * Gives a body, whose columns were brought to a time on its path, the velocity it has there.
     * After a share σ of the path's length it gets σ(3σ − 2) of what the path's velocity lacks at
     * its end, as on the cubic with the same ends.
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
