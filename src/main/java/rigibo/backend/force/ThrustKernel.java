package rigibo.backend.force;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;

/**
 * Turns the forces that were asked for into accelerations, a = F/m, and forgets them: the origin
 * report's thrust.
 */
public final class ThrustKernel {

    private final DataStorage data;

    /** Torques, or null where nothing turns. */
    private final TorqueKernel torque;

    /** A kernel for a pool that declares thrust; {@code torque} is null where nothing turns. */
    public ThrustKernel(DataStorage data, TorqueKernel torque) {
        this.data = data;
        this.torque = torque;
    }

    /** Adds to the accelerations of the bodies that forces were asked for. */
    public void accelerate(double dt) {
        Bodies bodies = data.bodies;
        Found thrusting = data.thrusting;
        for (int i = 0; i < thrusting.count; i++) {
            int slot = thrusting.numbers[i];
            if (bodies.isDynamic(slot)) {
                bodies.accelerationX[slot] += bodies.forceX[slot] * bodies.inverseMass[slot];
                bodies.accelerationY[slot] += bodies.forceY[slot] * bodies.inverseMass[slot];
            }
            bodies.forceX[slot] = 0;
            bodies.forceY[slot] = 0;
        }
        if (torque != null) {
            torque.accelerate();
        }
        thrusting.clear();
    }
}
