package rigibo.backend;

import rigibo.backend.effect.Gravity;
import rigibo.backend.saved.StateHash;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;

/** Sums over all bodies of a pool, in slot order. */
final class PoolTotals {

    private final Pool pool;
    private final DataStorage data;
    private final Bodies bodies;

    PoolTotals(Pool pool, DataStorage data) {
        this.pool = pool;
        this.data = data;
        bodies = data.bodies;
    }

    double kineticEnergy() {
        double sum = 0;
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            sum += bodies.kineticEnergy(slot);
        }
        return sum;
    }

    double potentialEnergy() {
        Gravity gravity = pool.effects().find(Gravity.class).orElse(new Gravity(0, 0));
        double sum = 0;
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (isDynamic(slot)) {
                double height = gravity.x() * bodies.x[slot] + gravity.y() * bodies.y[slot];
                sum -= bodies.mass[slot] * bodies.gravityScale[slot] * height;
            }
        }
        return sum;
    }

    double momentumX() {
        double sum = 0;
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            sum += isDynamic(slot) ? bodies.mass[slot] * bodies.velocityX[slot] : 0;
        }
        return sum;
    }

    double momentumY() {
        double sum = 0;
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            sum += isDynamic(slot) ? bodies.mass[slot] * bodies.velocityY[slot] : 0;
        }
        return sum;
    }

    double angularMomentum() {
        double sum = 0;
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (isDynamic(slot)) {
                double orbital =
                        bodies.x[slot] * bodies.velocityY[slot]
                                - bodies.y[slot] * bodies.velocityX[slot];
                sum += bodies.mass[slot] * orbital + bodies.angularMomentum(slot);
            }
        }
        return sum;
    }

    long stateHash() {
        return StateHash.of(data, pool.time(), pool.savedContacts());
    }

    private boolean isDynamic(int slot) {
        return bodies.type[slot] == BodyType.DYNAMIC;
    }
}
