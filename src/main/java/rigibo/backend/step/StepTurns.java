package rigibo.backend.step;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Quarantine;
import rigibo.backend.storage.Roster;

/** The work of a step on the rotation of all moving bodies; exists only if rotation is declared. */
final class StepTurns {

    private final Bodies bodies;
    private final Roster roster;

    StepTurns(DataStorage data) {
        bodies = data.bodies;
        roster = data.roster;
    }

    /** Stores the angle of each body at the start of the step. */
    void keepStart() {
        for (int i = 0; i < roster.awakeCount; i++) {
            bodies.keepStartAngle(roster.awake[i]);
        }
    }

    void clearAccelerations() {
        for (int i = 0; i < roster.awakeCount; i++) {
            bodies.clearAngularAcceleration(roster.awake[i]);
        }
    }

    /** Turns kinematic bodies by their angular velocities. */
    void turnDriven(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDriven(slot)) {
                bodies.turn(slot, dt * bodies.spin[slot]);
            }
        }
    }

    /** Whether the rotation of a body is within bounds, and will be at the end of the step. */
    boolean isBounded(int slot, double dt) {
        double w = Math.abs(bodies.spin[slot]) + Math.abs(bodies.angularAcceleration[slot]) * dt;
        return Quarantine.isBounded(w) && Math.abs(bodies.angle[slot]) < Double.POSITIVE_INFINITY;
    }
}
