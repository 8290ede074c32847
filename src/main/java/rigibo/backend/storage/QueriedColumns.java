package rigibo.backend.storage;

import rigibo.backend.effect.Effects;

import java.util.Arrays;

/**
 * A copy of the columns of bodies and pairs that queries read; all other columns are null. A query
 * that reads another column therefore fails until this class copies that column too.
 */
public final class QueriedColumns {

    public final Bodies bodies = new Bodies(Effects.of());
    public final Pairs pairs = new Pairs(Effects.of());

    /** A copy of nothing yet. */
    public QueriedColumns() {
        NoColumns none = new NoColumns();
        bodies.visitColumns(none);
        pairs.visitColumns(none);
    }

    /** Copies the columns of a storage; allocates only where they have grown. */
    public void copy(DataStorage from) {
        copyShapes(from.bodies, from.bodies.slots.high);
        copyPoses(from.bodies, from.bodies.slots.high);
        bodies.slots.high = from.bodies.slots.high;
        copyManifolds(from.pairs, from.pairs.slots.high);
        copyForces(from.pairs, from.pairs.slots.high);
        pairs.slots.high = from.pairs.slots.high;
    }

    private void copyShapes(Bodies from, int count) {
        bodies.type = copy(from.type, bodies.type, count, bodies.slots.high);
        bodies.shape = copy(from.shape, bodies.shape, count, bodies.slots.high);
        bodies.outline = copy(from.outline, bodies.outline, count, bodies.slots.high);
        bodies.owner = copy(from.owner, bodies.owner, count);
        bodies.nextShape = copy(from.nextShape, bodies.nextShape, count);
        bodies.part = copy(from.part, bodies.part, count);
        bodies.group = copy(from.group, bodies.group, count);
        bodies.category = copy(from.category, bodies.category, count);
        bodies.mask = copy(from.mask, bodies.mask, count);
        bodies.sensor = copy(from.sensor, bodies.sensor, count);
        bodies.disabled = copy(from.disabled, bodies.disabled, count);
    }

    private void copyPoses(Bodies from, int count) {
        bodies.x = copy(from.x, bodies.x, count);
        bodies.y = copy(from.y, bodies.y, count);
        bodies.angle = copy(from.angle, bodies.angle, count);
        bodies.cos = copy(from.cos, bodies.cos, count);
        bodies.sin = copy(from.sin, bodies.sin, count);
        bodies.velocityX = copy(from.velocityX, bodies.velocityX, count);
        bodies.velocityY = copy(from.velocityY, bodies.velocityY, count);
        bodies.spin = copy(from.spin, bodies.spin, count);
        bodies.awake = copy(from.awake, bodies.awake, count);
        bodies.firstPair = copy(from.firstPair, bodies.firstPair, count);
    }

    private void copyManifolds(Pairs from, int count) {
        pairs.bodyA = copy(from.bodyA, pairs.bodyA, count);
        pairs.bodyB = copy(from.bodyB, pairs.bodyB, count);
        pairs.shapesA = copy(from.shapesA, pairs.shapesA, count);
        pairs.shapesB = copy(from.shapesB, pairs.shapesB, count);
        pairs.next = copy(from.next, pairs.next, 2 * count);
        pairs.normalX = copy(from.normalX, pairs.normalX, count);
        pairs.normalY = copy(from.normalY, pairs.normalY, count);
        pairs.points = copy(from.points, pairs.points, count);
        pairs.pointX = copy(from.pointX, pairs.pointX, 2 * count);
        pairs.pointY = copy(from.pointY, pairs.pointY, 2 * count);
        pairs.separation = copy(from.separation, pairs.separation, 2 * count);
    }

    private void copyForces(Pairs from, int count) {
        pairs.normalForce = copy(from.normalForce, pairs.normalForce, 2 * count);
        pairs.frictionForce = copy(from.frictionForce, pairs.frictionForce, count);
        pairs.impulse = copy(from.impulse, pairs.impulse, count);
        pairs.impacts = copy(from.impacts, pairs.impacts, count);
        pairs.crushed = copy(from.crushed, pairs.crushed, count);
        pairs.touching = copy(from.touching, pairs.touching, count);
        pairs.touchedBefore = copy(from.touchedBefore, pairs.touchedBefore, count);
    }

    private static double[] copy(double[] from, double[] to, int count) {
        if (from == null) {
            return null;
        }
        double[] copy = to == null || to.length < count ? new double[from.length] : to;
        System.arraycopy(from, 0, copy, 0, count);
        return copy;
    }

    private static int[] copy(int[] from, int[] to, int count) {
        if (from == null) {
            return null;
        }
        int[] copy = to == null || to.length < count ? new int[from.length] : to;
        System.arraycopy(from, 0, copy, 0, count);
        return copy;
    }

    private static boolean[] copy(boolean[] from, boolean[] to, int count) {
        if (from == null) {
            return null;
        }
        boolean[] copy = to == null || to.length < count ? new boolean[from.length] : to;
        System.arraycopy(from, 0, copy, 0, count);
        return copy;
    }

    /** References beyond the new end are cleared, so that they can be collected as garbage. */
    private static <T> T[] copy(T[] from, T[] to, int count, int before) {
        if (to == null || to.length < count) {
            return from.clone();
        }
        System.arraycopy(from, 0, to, 0, count);
        if (before > count) {
            Arrays.fill(to, count, before, null);
        }
        return to;
    }
}
