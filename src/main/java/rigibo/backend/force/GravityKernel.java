package rigibo.backend.force;

import rigibo.backend.effect.Gravity;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Roster;

/** Adds the acceleration of gravity, times the body's own gravity scale. */
public final class GravityKernel {

    private final DataStorage data;
    private final Gravity gravity;

    /** A kernel for a declared gravity. */
    public GravityKernel(DataStorage data, Gravity gravity) {
        this.data = data;
        this.gravity = gravity;
    }

    /** Adds the acceleration to all awake dynamic bodies. */
    public void accelerate(double dt) {
        Bodies bodies = data.bodies;
        Roster roster = data.roster;
        double gx = gravity.x();
        double gy = gravity.y();
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.type[slot] == BodyType.DYNAMIC) {
                bodies.accelerationX[slot] += bodies.gravityScale[slot] * gx;
                bodies.accelerationY[slot] += bodies.gravityScale[slot] * gy;
            }
        }
    }
}
