package rigibo.backend.flight;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Roster;

/** The turning of bodies on the integrated paths of {@link Course}. */
final class TurningCourse {

    private final Bodies bodies;
    private final Deviation deviation;

    /** By body: spin that the laid path lacks at its end, rad/s. */
    private double[] lackSpin = new double[16];

    TurningCourse(Bodies bodies, Deviation deviation) {
        this.bodies = bodies;
        this.deviation = deviation;
    }

    /** Starts a step, before forces have turned any body. */
    void begin(Roster roster) {
        if (lackSpin.length < bodies.type.length) {
            lackSpin = new double[bodies.type.length];
        }
        for (int i = 0; i < roster.awakeCount; i++) {
            bodies.pullTurn[roster.awake[i]] = 0;
        }
    }

    /** Clears the correction of a body that gets a new path. */
    void forget(int slot) {
        lackSpin[slot] = 0;
    }

    /** Writes the turning of a body on a path with a length in s; see {@link Course#lay}. */
    void write(int slot, double length) {
        double turn = deviation.moved.turn / (length * length / 2);
        bodies.angularAcceleration[slot] = deviation.keepingTurn() + turn;
        bodies.pullTurn[slot] = deviation.keepingTurn() - deviation.steadyTurn() + turn;
        lackSpin[slot] = deviation.gained.turn - turn * length;
    }

    boolean lacksSpin(int slot) {
        return lackSpin[slot] != 0;
    }

    /** Adds a share of the spin that the path lacks to a body. */
    void catchUp(int slot, double share) {
        bodies.spin[slot] += share * lackSpin[slot];
        lackSpin[slot] = 0;
    }
}
