package rigibo.backend.force;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;

/**
 * Turns the forces and torques that were asked for into accelerations, a = F/m and α = τ/I, and
 * forgets them: the origin report's thrust.
 */
public final class ThrustKernel {

    private final DataStorage data;

    /** A kernel for a pool that declares thrust. */
    public ThrustKernel(DataStorage data) {
        this.data = data;
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
                bodies.angularAcceleration[slot] +=
                        bodies.torque[slot] * bodies.inverseInertia[slot];
            }
            bodies.clearForces(slot);
        }
        thrusting.clear();
    }
}
