package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;

/** The kicks of an island: adds accelerations to the velocities of its bodies. */
public final class Kick {

    /** Column that holds the length of the kick in s, beside the velocities before it. */
    static final int LENGTH = Motions.DX;

    private final Bodies bodies;
    private final Motions motions;

    /** By entry: velocities before the kick, later their gain in it; and its length, s. */
    private double[] gained = new double[16 * Motions.STRIDE];

    /** Forces that vary along the path; null if there are none. */
    private final IslandForces forces;

    /** Linear drag; null if it is not declared. */
    private final DragKick drag;

    /** Turning of the packed bodies; null without rotation. */
    private final PackedTurns turns;

    public Kick(
            Bodies bodies, Motions motions, IslandForces forces, DragKick drag, PackedTurns turns) {
        this.drag = drag;
        this.turns = turns;
        this.bodies = bodies;
        this.motions = motions;
        this.forces = forces;
    }

    /** Stores the velocities before the next kick. */
    public void remember() {
        int length = motions.count * Motions.STRIDE;
        if (gained.length < length) {
            gained = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, gained, 0, length);
        for (int at = 0; at < length; at += Motions.STRIDE) {
            gained[at + LENGTH] = 0;
        }
    }

    /**
     * Whether drag, or a force that varies along the path, acts on a packed body when the step
     * begins.
     */
    public boolean isForced() {
        boolean isForced = false;
        for (int entry = 1; !isForced && entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            if (motions.data[entry * Motions.STRIDE + Motions.INVERSE_MASS] > 0) {
                isForced = drag != null && bodies.drag[slot] > 0 || forces != null && pulls(slot);
            }
        }
        return isForced;
    }

    private boolean pulls(int slot) {
        return bodies.pullX[slot] != 0
                || bodies.pullY[slot] != 0
                || turns != null && bodies.pullTurn[slot] != 0;
    }

    /**
     * Writes the present forces into the accelerations, for a kick from one time to another (s
     * after the step's start), which may be the earlier one.
     */
    public void refresh(double from, double to) {
        if (forces != null) {
            forces.refresh(motions, turns, (from + to) / 2, to - from);
        }
    }

    /** Whether there are forces that vary along the path. */
    public boolean mayChange() {
        return forces != null;
    }

    /**
     * Whether kicks of h seconds, at times h apart from {@code first} on, accelerate all bodies as
     * the last kick did, within a tolerance in m/s².
     */
    public boolean isSteady(double first, double h, int kicks, double most) {
        boolean isSteady = true;
        for (int i = 0; forces != null && isSteady && i < kicks; i++) {
            forces.refresh(motions, turns, first + i * h, h);
            isSteady = forces.change() <= most;
        }
        return isSteady;
    }

    /** Greatest acceleration by the effects along an axis, m/s². */
    public double strongest() {
        double most = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            double ax = Math.abs(bodies.accelerationX[motions.slots[entry]]);
            double ay = Math.abs(bodies.accelerationY[motions.slots[entry]]);
            most = Math.max(most, Math.max(ax, ay));
        }
        return most;
    }

    /** Kinetic energy that a kick of h seconds gives to bodies at rest, J. */
    public double energy(double h) {
        double sum = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            double ax = bodies.accelerationX[slot];
            double ay = bodies.accelerationY[slot];
            double inverseMass = motions.data[entry * Motions.STRIDE + Motions.INVERSE_MASS];
            sum += inverseMass > 0 ? (ax * ax + ay * ay) / inverseMass : 0;
        }
        return sum * h * h / 2;
    }

    /** Measures the gain of all velocities per second of the kick, by contacts too. */
    public void measureGain() {
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            double length = gained[at + LENGTH];
            for (int column = at; column < at + Motions.DX; column++) {
                double gain = motions.data[column] - gained[column];
                gained[column] = length > 0 ? gain / length : 0;
            }
        }
    }

    /** Gain of a body's velocity per second of the kick, m/s², or rad/s² for its spin. */
    public double gained(int body, int column) {
        return gained[body + column];
    }

    /** Length of the kick for a body, s. */
    public double length(int body) {
        return gained[body + LENGTH];
    }

    /**
     * Advances the velocities from one time to a later one, both s after the step's start. A body
     * that joined the pile in between is kicked only from that time on.
     */
    public void accelerate(double from, double to) {
        refresh(from, to);
        if (drag != null) {
            drag.accelerate(from, to, gained);
        } else {
            accelerateFreely(from, to);
        }
        if (turns != null) {
            turns.accelerate(from, to);
        }
    }

    private void accelerateFreely(double from, double to) {
        double[] m = motions.data;
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            int at = entry * Motions.STRIDE;
            double length = to - Math.max(from, bodies.pileTime[slot]);
            if (m[at + Motions.INVERSE_MASS] > 0 && length > 0) {
                gained[at + LENGTH] = length;
                m[at + Motions.VX] += length * bodies.accelerationX[slot];
                m[at + Motions.VY] += length * bodies.accelerationY[slot];
            }
        }
    }
}
