package rigibo.backend.flight;

import rigibo.backend.collision.distance.Motion;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Roster;

/** The turning of each body within the step; {@link Trajectories} moves the centres of mass. */
final class TurningPaths {

    private final Bodies bodies;
    private final Trajectories paths;

    /** By body: predicted spin after it landed, rad/s. */
    private double[] expected = new double[16];

    TurningPaths(Bodies bodies, Trajectories paths) {
        this.bodies = bodies;
        this.paths = paths;
    }

    /** Grows the arrays to all bodies. */
    void reserve() {
        if (expected.length < bodies.type.length) {
            expected = new double[bodies.type.length];
        }
    }

    /** Sets the predicted spin of a body that has landed, rad/s. */
    void expect(int slot, double spin) {
        expected[slot] = spin;
    }

    /**
     * Writes the turning of a body on its path; bodies not in flight turn at a constant rate or
     * not.
     */
    void load(int slot, Motion out) {
        out.takeTurning(bodies, slot);
        if (paths.stands(slot)) {
            out.spin = 0;
            out.angularAcceleration = 0;
        } else if (!paths.isFlyer(slot)) {
            out.angularAcceleration = 0;
            if (paths.hasLanded(slot)) {
                out.spin = expected[slot];
            } else if (!bodies.isMoved(slot)) {
                out.spin = 0;
            }
        }
    }

    /** Turns all flyers to a time in s after the step's start, before they move there. */
    void advanceAll(Roster roster, double time) {
        for (int i = 0; i < roster.awakeCount; i++) {
            if (paths.isFlyer(roster.awake[i]) && !paths.stands(roster.awake[i])) {
                advance(roster.awake[i], time);
            }
        }
    }

    /** Turns a flyer to a time in s after the step's start, before it moves there. */
    void advance(int slot, double time) {
        double elapsed = time - paths.since(slot);
        double spin = bodies.spin[slot];
        double angular = bodies.angularAcceleration[slot];
        if (elapsed != 0 && (spin != 0 || angular != 0)) {
            bodies.turn(slot, elapsed * (spin + elapsed * angular / 2));
            bodies.spin[slot] = spin + elapsed * angular;
        }
    }
}
