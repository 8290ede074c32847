package rigibo.backend.force;

import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Roster;

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

    /** Adds to the accelerations of all awake dynamic bodies. */
    public void accelerate(double dt) {
        Bodies bodies = data.bodies;
        Roster roster = data.roster;
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.type[slot] == BodyType.DYNAMIC) {
                bodies.accelerationX[slot] += bodies.forceX[slot] * bodies.inverseMass[slot];
                bodies.accelerationY[slot] += bodies.forceY[slot] * bodies.inverseMass[slot];
                bodies.angularAcceleration[slot] +=
                        bodies.torque[slot] * bodies.inverseInertia[slot];
            }
            bodies.clearForces(slot);
        }
    }
}
