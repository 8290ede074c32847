package rigibo.backend.flight;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Roster;

/** Turns every body through a whole step, in pools with rotation but without contacts. */
final class OpenTurning {

    private final Bodies bodies;
    private final Roster roster;

    OpenTurning(DataStorage data) {
        bodies = data.bodies;
        roster = data.roster;
    }

    /** Turns every dynamic body for dt seconds: θ + ωt + ½αt². */
    void turn(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDynamic(slot)) {
                turn(slot, dt);
            }
        }
    }

    private void turn(int slot, double dt) {
        double spin = bodies.spin[slot];
        double angular = bodies.angularAcceleration[slot];
        if (spin != 0 || angular != 0) {
            bodies.turn(slot, dt * (spin + dt * angular / 2));
            bodies.spin[slot] = spin + dt * angular;
        }
    }
}
