package rigibo.backend.broadphase;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.PairIndex;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Roster;

/**
 * The broad phase: maintains the fixtures and finds pairs whose fixtures overlap. A fixture is
 * replaced only when its shape is about to leave it.
 */
public final class Broadphase {

    private final Bodies bodies;
    private final Pairs pairs;
    private final Roster roster;
    private final DataStorage data;

    /** Whether it also finds the visitors of sensors. */
    public boolean senses;

    private final SizeFixtures fixtures;
    private final FixtureStore store;

    /** The slots marked in {@link Bodies#refitted}. */
    private final Found moved = new Found();

    /** The broad phase of a storage. */
    public Broadphase(DataStorage data) {
        this.data = data;
        bodies = data.bodies;
        pairs = data.pairs;
        roster = data.roster;
        fixtures = new SizeFixtures(bodies);
        store = new FixtureStore(bodies);
    }

    /** Writes the first fixtures of a new body, one per shape. */
    public void add(int body) {
        for (int slot = body; slot != Pairs.NONE; slot = bodies.nextShapeOf(slot)) {
            fixtures.sweep(body, slot, 0, 0);
            fixtures.write(body, slot, 0);
            store.add(slot);
            noteRefit(slot);
        }
    }

    /**
     * Builds the tree for bodies whose fixtures are known, as after reading a snapshot. It may
     * differ from the tree that grew with the bodies, but queries find the same.
     */
    public void rebuild() {
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (bodies.type[slot] != null) {
                if (!bodies.isDisabled(bodies.bodyOf(slot))) {
                    store.add(slot);
                }
                // A body that was disabled meanwhile is skipped and unmarked when its turn comes.
                if (bodies.refitted[slot]) {
                    moved.add(slot);
                }
            }
        }
    }

    /** Removes a body and its pairs. */
    public void remove(int body) {
        forgetPairs(body);
        for (int slot = body; slot != Pairs.NONE; slot = bodies.nextShapeOf(slot)) {
            store.remove(slot);
        }
    }

    /** Writes new fixtures for a body that was placed elsewhere. */
    public void refit(int body) {
        for (int slot = body; slot != Pairs.NONE; slot = bodies.nextShapeOf(slot)) {
            fixtures.sweep(body, slot, 0, 0);
            lay(body, slot, 0);
        }
    }

    /** Resets the contacts of a body that was placed elsewhere. */
    public void forgetContacts(int slot) {
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            pairs.clear(p);
        }
    }

    /** Removes all pairs of a body. */
    public void forgetPairs(int slot) {
        while (bodies.firstPair[slot] != Pairs.NONE) {
            pairs.remove(bodies, bodies.firstPair[slot]);
        }
    }

    /** Removes a pair. */
    public void forgetPair(int pair) {
        pairs.remove(bodies, pair);
    }

    /** Stage 3: writes fixtures for a step of {@code dt} seconds and finds their pairs. */
    public void update(double dt) {
        coverAwake(dt);
        moved.sort();
        int last = Pairs.NONE;
        for (int i = 0; i < moved.count; i++) {
            int slot = moved.numbers[i];
            bodies.refitted[slot] = false;
            if (bodies.type[slot] != null && !bodies.isDisabled(bodies.bodyOf(slot))) {
                int body = bodies.bodyOf(slot);
                if (body != last) {
                    dropPairsApart(body);
                    last = body;
                }
                findPairs(slot);
            }
        }
        moved.clear();
    }

    private void coverAwake(double dt) {
        if (bodies.turns()) {
            for (int i = 0; i < roster.awakeCount; i++) {
                cover(roster.awake[i], dt, fixtures.turned(roster.awake[i], dt), true);
            }
        } else {
            for (int i = 0; i < roster.awakeCount; i++) {
                cover(roster.awake[i], dt, 0, true);
            }
        }
    }

    /**
     * Within a step, after a body's path has changed: extends its fixture over the rest of the step
     * (s). Pairs found become active.
     */
    public void follow(int body, double left) {
        int before = moved.count;
        cover(body, left, bodies.turns() ? fixtures.turned(body, left) : 0, false);
        while (moved.count > before) {
            meetNeighbours(body, moved.numbers[--moved.count]);
        }
    }

    /**
     * Within a step, for a body whose further path is unknown: extends its fixture over everything
     * within a reach (m) of it at (x, y), m, with the cosine and sine of its angle. No point of the
     * body goes farther than the reach, so each part covers its own surroundings, not those of the
     * whole body.
     */
    public void lookRound(int body, double x, double y, double cos, double sin, double reach) {
        for (int slot = body; slot != Pairs.NONE; slot = bodies.nextShapeOf(slot)) {
            fixtures.sweepBeside(body, slot, x, y, cos, sin, reach);
            if (!fixtures.isCovered(slot)) {
                fixtures.write(body, slot, 0);
                store.move(body, slot);
                meetNeighbours(body, slot);
            }
        }
    }

    /**
     * At the end of a step: gives new fixtures to bodies that impacts within a pile sent off the
     * predicted path, so that queries find them. Bodies that have not moved are skipped.
     */
    public void coverPoses() {
        for (int i = 0; i < roster.awakeCount; i++) {
            int body = roster.awake[i];
            if (hasMoved(body)) {
                coverPose(body);
            }
            if (!bodies.isMoved(body)) {
                settle(body);
            }
        }
    }

    private void settle(int body) {
        for (int slot = body; slot != Pairs.NONE; slot = bodies.nextShapeOf(slot)) {
            store.settle(slot);
        }
    }

    /**
     * After {@link #coverPoses}: finds the sensors that were reached by bodies with new fixtures.
     */
    public void meetVisitors() {
        for (int i = 0; i < moved.count; i++) {
            int slot = moved.numbers[i];
            Found found = store.meet(slot);
            for (int k = 0; k < found.count; k++) {
                int other = found.numbers[k];
                if (bodies.sensor[slot] || bodies.sensor[other]) {
                    visit(slot, other);
                }
            }
        }
    }

    private void coverPose(int body) {
        for (int slot = body; slot != Pairs.NONE; slot = bodies.nextShapeOf(slot)) {
            // Usually the fixture holds even the bounding circle, which is a faster test.
            fixtures.sweepAround(body, 0);
            if (fixtures.isCovered(slot)) {
                continue;
            }
            fixtures.sweep(body, slot, 0, 0);
            if (!fixtures.isCovered(slot)) {
                lay(body, slot, 0);
            }
        }
    }

    /**
     * Whether a body has left its pose at the start of the step; a stopped body may also have
     * moved.
     */
    private boolean hasMoved(int slot) {
        return bodies.x[slot] != bodies.startX[slot]
                || bodies.y[slot] != bodies.startY[slot]
                || bodies.turns() && bodies.angle[slot] != bodies.startAngle[slot];
    }

    private void meetNeighbours(int body, int slot) {
        bodies.refitted[slot] = false;
        findPairs(slot);
        for (int p = bodies.firstPair[body]; p != Pairs.NONE; p = pairs.nextOf(p, body)) {
            pairs.activateLate(p);
        }
    }

    /** Searches the fixtures by box and by ray, on the thread that steps, until its next step. */
    public FixtureSearch search() {
        return store.search();
    }

    FixtureStore store() {
        return store;
    }

    private void cover(int body, double dt, double turned, boolean isToFit) {
        boolean isAlone = bodies.firstPair[body] == Pairs.NONE;
        for (int slot = body; slot != Pairs.NONE; slot = bodies.nextShapeOf(slot)) {
            if (isAlone && !bodies.outline[slot].isEdge()) {
                fixtures.sweepAround(body, dt);
            } else {
                fixtures.sweep(body, slot, dt, turned);
            }
            if (!fixtures.isCovered(slot)
                    || isToFit && !isAlone && fixtures.isLoose(body, slot, dt)) {
                lay(body, slot, dt);
            }
        }
    }

    private void lay(int body, int slot, double dt) {
        fixtures.write(body, slot, dt);
        store.move(body, slot);
        noteRefit(slot);
    }

    private void noteRefit(int slot) {
        if (!bodies.refitted[slot]) {
            bodies.refitted[slot] = true;
            moved.add(slot);
        }
    }

    /**
     * Drops pairs whose fixtures have parted. A contact that just ended stays for one more step,
     * which reports its end.
     */
    private void dropPairsApart(int body) {
        int p = bodies.firstPair[body];
        while (p != Pairs.NONE) {
            int after = pairs.nextOf(p, body);
            if (!pairs.touched(p) && !fixturesOverlap(pairs.shapeA(p), pairs.shapeB(p))) {
                pairs.remove(bodies, p);
            }
            p = after;
        }
    }

    private void findPairs(int slot) {
        Found found = store.meet(slot);
        for (int i = 0; i < found.count; i++) {
            pair(slot, found.numbers[i]);
        }
    }

    private void pair(int slot, int other) {
        if (bodies.sensor != null && (bodies.sensor[slot] || bodies.sensor[other])) {
            visit(slot, other);
            return;
        }
        boolean isFirst = bodies.bodyOf(slot) < bodies.bodyOf(other);
        int shapeA = isFirst ? slot : other;
        int shapeB = isFirst ? other : slot;
        int a = bodies.bodyOf(shapeA);
        int b = bodies.bodyOf(shapeB);
        boolean collide =
                a != b
                        && (bodies.isDynamic(a) || bodies.isDynamic(b))
                        && bodies.meet(shapeA, shapeB)
                        && !(data.joints != null && data.joints.keepApart(a, b));
        if (collide && pairs.index.find(shapeA, shapeB) == PairIndex.ABSENT) {
            pairs.add(bodies, shapeA, shapeB);
        }
    }

    /** Notes a sensor and its visitor. Sensors do not detect sensors or parts of their own body. */
    private void visit(int slot, int other) {
        boolean isOne = bodies.sensor[slot] != bodies.sensor[other];
        boolean areApart = bodies.bodyOf(slot) != bodies.bodyOf(other);
        if (senses && isOne && areApart && bodies.meet(slot, other)) {
            data.visits.meet(bodies, slot, other);
        }
    }

    private boolean fixturesOverlap(int a, int b) {
        return bodies.fixtureMinX[a] <= bodies.fixtureMaxX[b]
                && bodies.fixtureMinX[b] <= bodies.fixtureMaxX[a]
                && bodies.fixtureMinY[a] <= bodies.fixtureMaxY[b]
                && bodies.fixtureMinY[b] <= bodies.fixtureMaxY[a];
    }
}
