package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;

/** Adds accelerations to the velocities of an island's bodies. */
public final class Kick {

    /** Where the length of the kick in s is kept, beside the velocities before it. */
    static final int LENGTH = Motions.DX;

    private final Bodies bodies;
    private final Motions motions;

    /** Velocities before the kick, then what they gained; and how long the kick was, s. */
    private double[] gained = new double[16 * Motions.STRIDE];

    /** Forces that change along the way, or null where there are none. */
    private final IslandForces forces;

    /** Linear drag, or null where none is declared. */
    private final DragKick drag;

    /** How bodies turn, or null where none does. */
    private final PackedTurns turns;

    public Kick(
            Bodies bodies, Motions motions, IslandForces forces, DragKick drag, PackedTurns turns) {
        this.drag = drag;
        this.turns = turns;
        this.bodies = bodies;
        this.motions = motions;
        this.forces = forces;
    }

    /** Keeps the velocities that the next kick begins with. */
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
     * Whether drag, or a force that changes along the way, acts on one of the packed bodies as the
     * step begins.
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
     * Puts the forces of now into the accelerations, for a kick from one time to another, both in s
     * after the step's start, which may go back.
     */
    public void refresh(double from, double to) {
        if (forces != null) {
            forces.refresh(motions, turns, (from + to) / 2, to - from);
        }
    }

    /** Whether there are forces that change along the way. */
    public boolean mayChange() {
        return forces != null;
    }

    /**
     * Whether kicks of h seconds at times h apart, from {@code first} on, accelerate all bodies as
     * the last one did, within a tolerance in m/s².
     */
    public boolean isSteady(double first, double h, int kicks, double most) {
        boolean isSteady = true;
        for (int i = 0; forces != null && isSteady && i < kicks; i++) {
            forces.refresh(motions, turns, first + i * h, h);
            isSteady = forces.change() <= most;
        }
        return isSteady;
    }

    /** The strongest acceleration by the effects along an axis, m/s². */
    public double strongest() {
        double most = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            double ax = Math.abs(bodies.accelerationX[motions.slots[entry]]);
            double ay = Math.abs(bodies.accelerationY[motions.slots[entry]]);
            most = Math.max(most, Math.max(ax, ay));
        }
        return most;
    }

    /** The energy of motion in J that a kick of h seconds gives what rests. */
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

    /** Measures what all velocities have gained per second of the kick, by loads too. */
    public void measureGain() {
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            double length = gained[at + LENGTH];
            for (int column = at; column < at + Motions.DX; column++) {
                double gain = motions.data[column] - gained[column];
                gained[column] = length > 0 ? gain / length : 0;
            }
        }
    }

    /** What a body's velocity gained in the kick, m/s², or rad/s² for its spin. */
    public double gained(int body, int column) {
        return gained[body + column];
    }

    /** How long the kick was for a body, s. */
    public double length(int body) {
        return gained[body + LENGTH];
    }

    /**
     * Moves the velocities from one time to a later one, both in s after the step's start. A body
     * that joined the pile in between is kicked only from when it joined.
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
