package rigibo.backend.force;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;

/** Turns applied torques into angular accelerations, α = τ/I, and clears them. */
public final class TorqueKernel {

    private final DataStorage data;

    /** A kernel for a pool that declares thrust and rotation. */
    public TorqueKernel(DataStorage data) {
        this.data = data;
    }

    /** Adds the angular accelerations of all bodies to which torques are applied. */
    void accelerate() {
        Bodies bodies = data.bodies;
        Found thrusting = data.thrusting;
        for (int i = 0; i < thrusting.count; i++) {
            int slot = thrusting.numbers[i];
            if (bodies.isDynamic(slot)) {
                bodies.angularAcceleration[slot] +=
                        bodies.torque[slot] * bodies.inverseInertia[slot];
            }
            bodies.torque[slot] = 0;
        }
    }
}
