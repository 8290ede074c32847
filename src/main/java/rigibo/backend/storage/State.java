package rigibo.backend.storage;

import rigibo.backend.setup.BodyType;

import java.util.Arrays;

/**
 * The one description of what a pool's columns carry from step to step: whatever is not listed here
 * follows from what is, or is written anew in a step before it is read.
 */
final class State {

    private static final BodyType[] TYPES = BodyType.values();

    /** Fewer bytes than any body or pair takes when it is written. */
    private static final int LEAST_BYTES = 100;

    private static final int NUMBER_BYTES = 4;

    private final Codec codec;

    /** The occupied slots of the columns in hand, ascending. */
    private int[] rows = {};

    private State(Codec codec) {
        this.codec = codec;
    }

    /** Shows all bodies and pairs to a codec, which may write them. */
    static void visit(DataStorage data, Codec codec) {
        State state = new State(codec);
        state.visitBodies(data.bodies);
        state.visitPairs(data.pairs);
    }

    private void visitBodies(Bodies b) {
        b.reserve(visitSlots("body slots", b.slots));
        // The names of the types stand in the label, for only their order is written.
        codec.label("type " + Arrays.toString(TYPES));
        for (int slot : rows) {
            b.type[slot] = type(b.type[slot]);
        }
        values("shape", Form.SHAPE, b.shape);
        values("material", Form.MATERIAL, b.material);
        column("group", b.group);
        column("gravityScale", b.gravityScale);
        column("statedMass", b.statedMass);
        column("statedInertia", b.statedInertia);
        visitMotion(b);
        column("awake", b.awake);
        if (b.firstPair != null) {
            visitFixture(b);
        }
        declared("stillTime", b.stillTime);
        declared("stillX", b.stillX);
        declared("stillY", b.stillY);
        // Where nothing turned since, the anchor is the angle, as where nothing turns at all.
        declared("stillAngle", b.stillAngle, b.angle);
    }

    private void visitMotion(Bodies b) {
        column("x", b.x);
        column("y", b.y);
        column("angle", b.angle);
        column("velocityX", b.velocityX);
        column("velocityY", b.velocityY);
        declared("spin", b.spin);
        // A sleeper's stay what they were when it fell asleep: they tell who leans on whom.
        column("accelerationX", b.accelerationX);
        column("accelerationY", b.accelerationY);
        declared("angularAcceleration", b.angularAcceleration);
        declared("forceX", b.forceX);
        declared("forceY", b.forceY);
        declared("torque", b.torque);
    }

    private void visitFixture(Bodies b) {
        column("fixtureMinX", b.fixtureMinX);
        column("fixtureMinY", b.fixtureMinY);
        column("fixtureMaxX", b.fixtureMaxX);
        column("fixtureMaxY", b.fixtureMaxY);
        column("refitted", b.refitted);
        column("firstPair", b.firstPair);
    }

    private void visitPairs(Pairs p) {
        p.reserve(visitSlots("pair slots", p.slots));
        column("bodyA", p.bodyA);
        column("bodyB", p.bodyB);
        twin("next", p.next);
        twin("previous", p.previous);
        column("normalX", p.normalX);
        column("normalY", p.normalY);
        column("faceOf", p.faceOf);
        column("points", p.points);
        twin("pointX", p.pointX);
        twin("pointY", p.pointY);
        twin("separation", p.separation);
        twin("feature", p.feature);
        twin("normalForce", p.normalForce);
        twin("load", p.load);
        declared("frictionForce", p.frictionForce);
        declared("rollingTorque", p.rollingTorque);
        column("impulse", p.impulse);
        column("impacts", p.impacts);
        column("crushed", p.crushed);
        column("resting", p.resting);
        column("touching", p.touching);
        column("touchedBefore", p.touchedBefore);
    }

    /** Slots and which of them are free, in the order they will be handed out; answers how many. */
    private int visitSlots(String name, Slots slots) {
        codec.label(name);
        int inUse = codec.count(slots.inUse(), LEAST_BYTES);
        int freeCount = codec.count(slots.freeCount, NUMBER_BYTES);
        slots.high = inUse + freeCount;
        slots.freeCount = freeCount;
        slots.reserveFree();
        for (int i = 0; i < freeCount; i++) {
            slots.free[i] = codec.number(slots.free[i]);
        }
        rows = slots.occupied();
        return slots.high;
    }

    private BodyType type(BodyType type) {
        int number = codec.number(type == null ? 0 : type.ordinal());
        if (number < 0 || number >= TYPES.length) {
            throw new IllegalArgumentException(
                    "a body's type must be 0 to " + (TYPES.length - 1) + ", was " + number);
        }
        return TYPES[number];
    }

    private <T> void values(String name, Form<T> form, T[] column) {
        codec.label(name);
        for (int slot : rows) {
            column[slot] = codec.value(form, column[slot]);
        }
    }

    private void column(String name, int[] column) {
        codec.label(name);
        for (int slot : rows) {
            column[slot] = codec.number(column[slot]);
        }
    }

    private void column(String name, double[] column) {
        codec.label(name);
        for (int slot : rows) {
            column[slot] = codec.number(column[slot]);
        }
    }

    private void column(String name, boolean[] column) {
        codec.label(name);
        for (int slot : rows) {
            column[slot] = codec.flag(column[slot]);
        }
    }

    /** A column that only a declared effect needs. */
    private void declared(String name, double[] column) {
        declared(name, column, null);
    }

    private void declared(String name, double[] column, double[] idle) {
        if (column != null && codec.keeps(name, column, idle, rows)) {
            column(name, column);
        }
    }

    /** A column of two values per slot. */
    private void twin(String name, int[] column) {
        codec.label(name);
        for (int slot : rows) {
            column[2 * slot] = codec.number(column[2 * slot]);
            column[2 * slot + 1] = codec.number(column[2 * slot + 1]);
        }
    }

    private void twin(String name, double[] column) {
        codec.label(name);
        for (int slot : rows) {
            column[2 * slot] = codec.number(column[2 * slot]);
            column[2 * slot + 1] = codec.number(column[2 * slot + 1]);
        }
    }
}
