package rigibo.backend.step;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.Quarantine;
import rigibo.backend.storage.Roster;

/** What a step does for every body that moves, whatever the effects. */
final class StepBodies {

    private final Bodies bodies;
    private final Roster roster;
    private final Quarantine quarantine;

    private final Found steered;
    private final Steering steering;

    /** The same for what turns, or null where nothing does. */
    private final StepTurns turning;

    StepBodies(DataStorage data) {
        quarantine = new Quarantine(data);
        turning = data.bodies.turns() ? new StepTurns(data) : null;
        steered = data.steered;
        steering = new Steering(data);
        bodies = data.bodies;
        roster = data.roster;
    }

    /** Lists the bodies that move and remembers where each begins. */
    void accept(double dt) {
        if (steered.count > 0) {
            steering.steer(dt);
        }
        roster.refresh(bodies);
        for (int i = 0; i < roster.awakeCount; i++) {
            bodies.keepStart(roster.awake[i]);
        }
        if (turning != null) {
            turning.keepStart();
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
        if (turning != null) {
            turning.clearAccelerations();
        }
    }

    /** Kinematic bodies go exactly as told, after the piles that were pushed by them. */
    void moveDriven(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDriven(slot)) {
                bodies.x[slot] += dt * bodies.velocityX[slot];
                bodies.y[slot] += dt * bodies.velocityY[slot];
            }
        }
        if (turning != null) {
            turning.turnDriven(dt);
        }
    }

    /**
     * Puts bodies to rest where the step began whose state is, or by this step would be, beyond all
     * bounds. Asked before anything can touch them, and once more at the end.
     */
    void quarantine(double dt) {
        if (turning == null) {
            quarantineMoving(dt);
        } else {
            quarantineTurning(dt);
        }
    }

    private void quarantineMoving(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            if (!isBounded(roster.awake[i], dt)) {
                quarantine.putToRest(roster.awake[i]);
            }
        }
    }

    /** Both at once, so that bodies are named in the order of their slots. */
    private void quarantineTurning(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (!isBounded(slot, dt) || !turning.isBounded(slot, dt)) {
                quarantine.putToRest(slot);
            }
        }
    }

    private boolean isBounded(int slot, double dt) {
        double vx = Math.abs(bodies.velocityX[slot]) + Math.abs(bodies.accelerationX[slot]) * dt;
        double vy = Math.abs(bodies.velocityY[slot]) + Math.abs(bodies.accelerationY[slot]) * dt;
        double place = Math.max(Math.abs(bodies.x[slot]), Math.abs(bodies.y[slot]));
        return Quarantine.isBounded(vx)
                && Quarantine.isBounded(vy)
                && place < Double.POSITIVE_INFINITY;
    }
}
