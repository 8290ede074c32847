package rigibo.backend.step;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.Quarantine;
import rigibo.backend.storage.Roster;

/** The work of a step on all moving bodies, whatever effects are declared. */
final class StepBodies {

    private final Bodies bodies;
    private final Roster roster;
    private final Quarantine quarantine;

    private final Found steered;
    private final Steering steering;

    /** Does the corresponding work on rotation; null without rotation. */
    private final StepTurns turning;

    StepBodies(DataStorage data) {
        quarantine = new Quarantine(data);
        turning = data.bodies.turns() ? new StepTurns(data) : null;
        steered = data.steered;
        steering = new Steering(data);
        bodies = data.bodies;
        roster = data.roster;
    }

    /** Lists the moving bodies and stores the position of each at the start of the step. */
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

    /** Marks all bodies as in flight. */
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

    /** Moves kinematic bodies exactly by their velocities, after the piles that they push. */
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
     * Puts bodies to rest where the step began if their state is out of bounds, or would be at the
     * end of this step. Runs before anything can touch them, and again at the end.
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

    /**
     * Checks motion and rotation together, so that bodies are named in the order of their slots.
     */
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
