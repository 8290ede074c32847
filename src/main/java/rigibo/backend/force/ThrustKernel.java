package rigibo.backend.force;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;

/** Turns applied forces into accelerations, a = F/m, and clears them. */
public final class ThrustKernel {

    private final DataStorage data;

    /** Kernel for applied torques; null without rotation. */
    private final TorqueKernel torque;

    /** A kernel for a pool that declares thrust; {@code torque} is null without rotation. */
    public ThrustKernel(DataStorage data, TorqueKernel torque) {
        this.data = data;
        this.torque = torque;
    }

    /** Adds the accelerations of all bodies to which forces are applied. */
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
