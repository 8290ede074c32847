package rigibo.backend.force;

import rigibo.backend.effect.Wind;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Roster;

/** The acceleration k·w that a steady wind w adds to linear drag, so that v′ = a − k·(v − w). */
public final class WindKernel {

    private final DataStorage data;
    private final Wind wind;

    /** A kernel for a declared steady wind where linear drag is declared. */
    public WindKernel(DataStorage data, Wind wind) {
        this.data = data;
        this.wind = wind;
    }

    /** Adds the acceleration to all awake dynamic bodies. */
    public void accelerate(double dt) {
        Bodies bodies = data.bodies;
        Roster roster = data.roster;
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDynamic(slot)) {
                bodies.accelerationX[slot] += bodies.drag[slot] * wind.x();
                bodies.accelerationY[slot] += bodies.drag[slot] * wind.y();
            }
        }
    }
}
