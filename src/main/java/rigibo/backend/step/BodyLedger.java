package rigibo.backend.step;

import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Roster;

import java.util.Arrays;

/** What a step does for every body that moves, whatever the effects. */
final class BodyLedger {

    /** A body faster than this is beyond what doubles can collide, m/s. */
    private static final double FASTEST = 10 * BodyDefinition.MOST_SPEED;

    private final DataStorage data;
    private final Bodies bodies;
    private final Roster roster;

    BodyLedger(DataStorage data) {
        this.data = data;
        bodies = data.bodies;
        roster = data.roster;
    }

    /** Lists the bodies that move and remembers where each begins. */
    void accept(double dt) {
        roster.refresh(bodies);
        for (int i = 0; i < roster.awakeCount; i++) {
            bodies.keepStart(roster.awake[i]);
        }
    }

    /** Takes all for flyers. */
    void scatter(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            bodies.piled[roster.awake[i]] = false;
            bodies.pileTime[roster.awake[i]] = 0;
        }
    }

    void clearAccelerations(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            bodies.clearAccelerations(roster.awake[i]);
        }
    }

    /** Kinematic bodies go exactly as told, after the piles that were pushed by them. */
    void moveDriven(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDriven(slot)) {
                bodies.x[slot] += dt * bodies.velocityX[slot];
                bodies.y[slot] += dt * bodies.velocityY[slot];
                bodies.turn(slot, dt * bodies.spin[slot]);
            }
        }
    }

    /**
     * Puts bodies to rest where the step began whose state is, or by this step would be, beyond all
     * bounds. Asked before anything can touch them, and once more at the end.
     */
    void quarantine(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (!isBounded(slot, dt)) {
                putToRest(slot);
            }
        }
    }

    private boolean isBounded(int slot, double dt) {
        double vx = Math.abs(bodies.velocityX[slot]) + Math.abs(bodies.accelerationX[slot]) * dt;
        double vy = Math.abs(bodies.velocityY[slot]) + Math.abs(bodies.accelerationY[slot]) * dt;
        double w = Math.abs(bodies.spin[slot]) + Math.abs(bodies.angularAcceleration[slot]) * dt;
        double place =
                Math.abs(bodies.x[slot]) + Math.abs(bodies.y[slot]) + Math.abs(bodies.angle[slot]);
        return vx < FASTEST && vy < FASTEST && w < FASTEST && place < Double.POSITIVE_INFINITY;
    }

    private void putToRest(int slot) {
        bodies.x[slot] = bodies.startX[slot];
        bodies.y[slot] = bodies.startY[slot];
        bodies.angle[slot] = bodies.startAngle[slot];
        bodies.turn(slot, 0);
        bodies.velocityX[slot] = 0;
        bodies.velocityY[slot] = 0;
        bodies.spin[slot] = 0;
        bodies.clearAccelerations(slot);
        // A driven body stands still now and is no longer of those that move.
        roster.isStale = true;
        int[] noted = data.counters.quarantined;
        if (Arrays.stream(noted, 0, data.counters.quarantinedCount).noneMatch(s -> s == slot)) {
            data.counters.quarantine(slot);
        }
    }
}
