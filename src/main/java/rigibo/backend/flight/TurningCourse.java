package rigibo.backend.flight;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Roster;

/** How bodies turn under forces that change along the way, beside where these take them. */
final class TurningCourse {

    private final Bodies bodies;
    private final Deviation deviation;

    /** Per body: what the spin lacks at the path's end, rad/s. */
    private double[] lackSpin = new double[16];

    TurningCourse(Bodies bodies, Deviation deviation) {
        this.bodies = bodies;
        this.deviation = deviation;
    }

    /** Begins a step, in which these forces have turned nothing yet. */
    void begin(Roster roster) {
        if (lackSpin.length < bodies.type.length) {
            lackSpin = new double[bodies.type.length];
        }
        for (int i = 0; i < roster.awakeCount; i++) {
            bodies.pullTurn[roster.awake[i]] = 0;
        }
    }

    /** Begins another path. */
    void forget(int slot) {
        lackSpin[slot] = 0;
    }

    /** Writes how the body turns on the integrated path of a length in s: {@link Course#lay}. */
    void write(int slot, double length) {
        double turn = deviation.moved.turn / (length * length / 2);
        bodies.angularAcceleration[slot] = deviation.keepingTurn() + turn;
        bodies.pullTurn[slot] = deviation.keepingTurn() - deviation.steadyTurn() + turn;
        lackSpin[slot] = deviation.gained.turn - turn * length;
    }

    boolean lacksSpin(int slot) {
        return lackSpin[slot] != 0;
    }

    /** Gives a body a share of the spin that its path lacks. */
    void catchUp(int slot, double share) {
        bodies.spin[slot] += share * lackSpin[slot];
        lackSpin[slot] = 0;
    }
}
