package rigibo.backend.step;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Quarantine;
import rigibo.backend.storage.Roster;

/** What a step does besides for every body that moves, where bodies turn. */
final class StepTurns {

    private final Bodies bodies;
    private final Roster roster;

    StepTurns(DataStorage data) {
        bodies = data.bodies;
        roster = data.roster;
    }

    /** Remembers at which angle each begins. */
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

    /** Turns kinematic bodies as told. */
    void turnDriven(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDriven(slot)) {
                bodies.turn(slot, dt * bodies.spin[slot]);
            }
        }
    }

    /** Whether a body turns, and will by the end of the step, within all bounds. */
    boolean isBounded(int slot, double dt) {
        double w = Math.abs(bodies.spin[slot]) + Math.abs(bodies.angularAcceleration[slot]) * dt;
        return Quarantine.isBounded(w) && Math.abs(bodies.angle[slot]) < Double.POSITIVE_INFINITY;
    }
}
