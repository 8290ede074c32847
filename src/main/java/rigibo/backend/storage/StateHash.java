package rigibo.backend.storage;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Material;

/**
 * A 64-bit hash of every bit that the future depends on: time, bodies in slot order, and what the
 * contacts carry from step to step. Derived columns (bounds, manifolds) are left out.
 */
public final class StateHash {

    private static final long SEED = 0x243F6A8885A308D3L;
    private static final long ODD = 0x9E3779B97F4A7C15L;

    private long hash = SEED;

    private StateHash() {}

    /** The hash of a pool's data at a time in s. */
    public static long of(DataStorage data, double time) {
        StateHash state = new StateHash();
        state.fold(time);
        state.foldSlots(data.bodies.slots);
        for (int slot = 0; slot < data.bodies.slots.high; slot++) {
            if (data.bodies.type[slot] != null) {
                state.foldBody(data.bodies, slot);
            }
        }
        state.foldSlots(data.pairs.slots);
        for (int pair = 0; pair < data.pairs.slots.high; pair++) {
            if (data.pairs.bodyA[pair] != Pairs.NONE) {
                state.foldPair(data.pairs, pair);
            }
        }
        return state.hash;
    }

    private void foldBody(Bodies b, int slot) {
        fold(b.type[slot].ordinal() + 8L * b.group[slot] + (b.awake[slot] ? 4 : 0));
        foldShape(b.shape[slot]);
        foldMaterial(b.material[slot]);
        fold(b.gravityScale[slot]);
        fold(b.mass[slot]);
        fold(b.inertia[slot]);
        fold(b.x[slot]);
        fold(b.y[slot]);
        fold(b.angle[slot]);
        fold(b.velocityX[slot]);
        fold(b.velocityY[slot]);
        fold(b.spin[slot]);
        fold(b.stillTime[slot]);
        fold(b.stillX[slot]);
        fold(b.stillY[slot]);
        fold(b.stillAngle[slot]);
        fold(b.fixtureMinX[slot]);
        fold(b.fixtureMinY[slot]);
        fold(b.fixtureMaxX[slot]);
        fold(b.fixtureMaxY[slot]);
        if (b.forceX != null) {
            fold(b.forceX[slot]);
            fold(b.forceY[slot]);
            fold(b.torque[slot]);
        }
    }

    /** Corner by corner: the hash code of a record may differ from JVM to JVM. */
    private void foldShape(Shape shape) {
        if (shape instanceof Polygon) {
            Polygon polygon = (Polygon) shape;
            for (int i = 0; i < polygon.corners(); i++) {
                fold(polygon.cornerX(i));
                fold(polygon.cornerY(i));
            }
        } else {
            fold(shape.boundingRadius());
        }
    }

    private void foldMaterial(Material material) {
        fold(material.density());
        fold(material.friction());
        fold(material.elasticity());
        fold(material.rollingResistance());
        fold(material.surfaceSpeed());
        fold(material.drag());
    }

    private void foldPair(Pairs p, int pair) {
        fold(pair + ((long) p.bodyA[pair] << 32));
        fold(p.bodyB[pair] + (p.resting[pair] ? 1L << 40 : 0) + ((long) p.points[pair] << 41));
        for (int point = 2 * pair; point < 2 * pair + p.points[pair]; point++) {
            fold(p.feature[point]);
            fold(p.normalForce[point]);
            fold(p.load[point]);
        }
        fold(p.frictionForce[pair]);
        fold(p.rollingTorque[pair]);
    }

    private void foldSlots(Slots slots) {
        fold(slots.high);
        for (int i = 0; i < slots.freeCount; i++) {
            fold(slots.free[i]);
        }
    }

    private void fold(double value) {
        fold(Double.doubleToRawLongBits(value));
    }

    /**
     * Multiply and rotate, as in the finalizers of the splittable generators (Steele et al. 2014).
     */
    private void fold(long bits) {
        hash = (Long.rotateLeft(hash ^ bits, 27)) * ODD;
        hash ^= hash >>> 29;
    }
}
