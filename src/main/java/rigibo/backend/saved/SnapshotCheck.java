package rigibo.backend.saved;

import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Visits;

import java.util.Arrays;

/**
 * Rejects a snapshot that is well formed but describes an impossible pool: numbers that are not
 * finite, slots out of range, lists without an end.
 */
final class SnapshotCheck {

    private final Snapshot snapshot;
    private final Bodies bodies;

    private SnapshotCheck(Snapshot snapshot) {
        this.snapshot = snapshot;
        bodies = snapshot.data.bodies;
    }

    /**
     * Checks a whole snapshot.
     *
     * @throws IllegalArgumentException naming what is wrong
     */
    static void require(Snapshot snapshot) {
        SnapshotCheck check = new SnapshotCheck(snapshot);
        Require.notNegative("time", snapshot.time, "s");
        for (int slot : check.bodies.slots.occupied()) {
            check.requireBody(slot);
        }
        if (check.bodies.holdsCompounds()) {
            check.requireParts();
        }
        check.requireOrder();
        PairLinks.require(snapshot.data);
        check.requireVisits(snapshot.data.visits);
        if (snapshot.data.joints != null) {
            JointLinks.require(check.bodies, snapshot.data.joints, snapshot.jointOrder);
        }
        for (SavedContact contact : snapshot.ended) {
            contact.require(check.bodies);
        }
    }

    private void requireBody(int slot) {
        double most = BodyDefinition.MOST_GRAVITY_SCALE;
        Require.within("gravityScale", bodies.gravityScale[slot], -most, most, "no unit");
        Require.notNegative("statedMass", bodies.statedMass[slot], "kg");
        Require.notNegative("statedInertia", bodies.statedInertia[slot], "kg·m²");
        Require.finite("x", bodies.x[slot], "m");
        Require.finite("y", bodies.y[slot], "m");
        Require.finite("angle", bodies.angle[slot], "rad");
        Require.finite("velocityX", bodies.velocityX[slot], "m/s");
        Require.finite("velocityY", bodies.velocityY[slot], "m/s");
        Require.finite("accelerationX", bodies.accelerationX[slot], "m/s²");
        Require.finite("accelerationY", bodies.accelerationY[slot], "m/s²");
        if (bodies.pullX != null) {
            Require.finite("pullX", bodies.pullX[slot], "m/s²");
            Require.finite("pullY", bodies.pullY[slot], "m/s²");
        }
        if (bodies.pullTurn != null) {
            Require.finite("pullTurn", bodies.pullTurn[slot], "rad/s²");
        }
        if (bodies.turns()) {
            Require.finite("spin", bodies.spin[slot], "rad/s");
            Require.finite("angularAcceleration", bodies.angularAcceleration[slot], "rad/s²");
        }
        requireStill(slot);
        if (bodies.stillTime != null) {
            requireStillness(slot);
        }
        if (bodies.firstPair != null) {
            requireFixture(slot);
        }
    }

    private void requireVisits(Visits visits) {
        for (int i = 0; visits != null && i < visits.count; i++) {
            requireShapeAt(visits.sensor[i]);
            requireShapeAt(visits.visitor[i]);
            Require.within("visit", visits.state[i], Visits.OUTSIDE, Visits.PASSED);
        }
    }

    private void requireShapeAt(int slot) {
        if (slot < 0 || slot >= bodies.slots.high || bodies.type[slot] == null) {
            throw new IllegalArgumentException("a visit must name shapes, was slot " + slot);
        }
    }

    private void requireStillness(int slot) {
        Require.notNegative("stillTime", bodies.stillTime[slot], "s");
        Require.finite("stillX", bodies.stillX[slot], "m");
        Require.finite("stillY", bodies.stillY[slot], "m");
        if (bodies.stillAngle != null) {
            Require.finite("stillAngle", bodies.stillAngle[slot], "rad");
        }
    }

    private void requireFixture(int slot) {
        boolean isBox =
                bodies.fixtureMinX[slot] <= bodies.fixtureMaxX[slot]
                        && bodies.fixtureMinY[slot] <= bodies.fixtureMaxY[slot];
        if (!isBox) {
            throw new IllegalArgumentException(
                    "a fixture's least x and y must not be over its greatest, slot " + slot);
        }
    }

    private void requireStill(int slot) {
        boolean moves =
                bodies.velocityX[slot] != 0
                        || bodies.velocityY[slot] != 0
                        || bodies.spinOf(slot) != 0;
        if (moves && bodies.type[slot] == BodyType.STATIC) {
            throw new IllegalArgumentException(
                    "a static body's velocity and spin must be 0, slot " + slot);
        }
    }

    /**
     * Checks that every body has a slot for each part of its shape, in order, and that no slot is
     * left over.
     */
    private void requireParts() {
        int had = 0;
        for (int body : bodies.slots.occupied()) {
            if (bodies.isBody(body)) {
                had += requireParts(body);
            }
        }
        if (had != bodies.slots.inUse()) {
            throw new IllegalArgumentException(
                    "every slot must be of a body's part, "
                            + (bodies.slots.inUse() - had)
                            + " are not");
        }
    }

    private int requireParts(int body) {
        int count = bodies.shape[body].parts();
        int slot = body;
        for (int part = 0; part < count; part++) {
            boolean isPart =
                    slot >= 0
                            && slot < bodies.slots.high
                            && bodies.type[slot] == bodies.type[body]
                            && bodies.owner[slot] == body
                            && bodies.part[slot] == part;
            if (!isPart) {
                throw new IllegalArgumentException(
                        "part "
                                + part
                                + " of the body in slot "
                                + body
                                + " cannot be slot "
                                + slot);
            }
            slot = bodies.nextShape[slot];
        }
        if (slot != Pairs.NONE) {
            throw new IllegalArgumentException(
                    "the body in slot " + body + " has " + count + " parts, and one more: " + slot);
        }
        return count;
    }

    /** Checks that the order of the bodies names every body once. */
    private void requireOrder() {
        long count = Arrays.stream(bodies.slots.occupied()).filter(bodies::isBody).count();
        if (snapshot.order.length != count) {
            throw new IllegalArgumentException(
                    "the order of the bodies must name "
                            + count
                            + " bodies, was "
                            + snapshot.order.length);
        }
        boolean[] isNamed = new boolean[bodies.slots.high];
        for (int slot : snapshot.order) {
            requireBodyAt("the order of the bodies", bodies, slot);
            if (isNamed[slot]) {
                throw new IllegalArgumentException(
                        "the order of the bodies must name slot " + slot + " once, was twice");
            }
            isNamed[slot] = true;
        }
    }

    /** Rejects a slot that holds no body. */
    static void requireBodyAt(String where, Bodies bodies, int slot) {
        if (slot < 0 || slot >= bodies.slots.high || !bodies.isBody(slot)) {
            throw new IllegalArgumentException(where + " must name bodies, was slot " + slot);
        }
    }
}
