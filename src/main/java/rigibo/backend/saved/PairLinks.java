package rigibo.backend.saved;

import rigibo.backend.setup.Require;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairIndex;
import rigibo.backend.storage.Pairs;

/** Rejects pairs from a snapshot with impossible bodies, points or lists. */
final class PairLinks {

    private static final int MOST_POINTS = 2;

    private final Bodies bodies;
    private final Pairs pairs;
    private final boolean[] isPair;

    /** Ends of pairs found in lists so far; every pair must be found at both ends. */
    private int linked;

    private PairLinks(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
        isPair = new boolean[pairs.slots.high];
    }

    /**
     * Checks every pair and every list.
     *
     * @throws IllegalArgumentException naming what is wrong
     */
    static void require(DataStorage data) {
        PairLinks links = new PairLinks(data);
        PairIndex known = new PairIndex();
        for (int pair : data.pairs.slots.occupied()) {
            links.requirePair(pair, known);
        }
        for (int body : data.bodies.slots.occupied()) {
            links.requireList(body);
        }
        if (links.linked != 2 * data.pairs.slots.inUse()) {
            throw new IllegalArgumentException(
                    "every pair must be in the lists of both its bodies, "
                            + links.linked
                            + " ends are");
        }
    }

    private void requirePair(int pair, PairIndex known) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        SnapshotCheck.requireBodyAt("a pair", bodies, a);
        SnapshotCheck.requireBodyAt("a pair", bodies, b);
        int shapeA = pairs.shapeA(pair);
        int shapeB = pairs.shapeB(pair);
        boolean canMeet =
                a < b
                        && (bodies.isDynamic(a) || bodies.isDynamic(b))
                        && isShapeOf(a, shapeA)
                        && isShapeOf(b, shapeB);
        if (!canMeet || known.find(shapeA, shapeB) != PairIndex.ABSENT) {
            throw new IllegalArgumentException(
                    "a pair must be of two bodies, the lower slot first, one of them dynamic, and"
                            + " named once, was "
                            + a
                            + " and "
                            + b);
        }
        known.put(shapeA, shapeB, pair);
        isPair[pair] = true;
        Require.within("points", pairs.points[pair], 0, MOST_POINTS);
        if (pairs.passage != null) {
            Require.within("passage", pairs.passage[pair], Pairs.UNDECIDED, Pairs.COMES_THROUGH);
        }
        Require.within("impacts", pairs.impacts[pair], 0, Integer.MAX_VALUE);
    }

    private boolean isShapeOf(int body, int slot) {
        return slot >= 0
                && slot < bodies.slots.high
                && bodies.type[slot] != null
                && bodies.bodyOf(slot) == body;
    }

    /** Checks a list: if all its links back are right, it cannot run into itself. */
    private void requireList(int body) {
        int before = Pairs.NONE;
        int pair = bodies.firstPairOf(body);
        while (pair != Pairs.NONE) {
            if (!isInListAfter(pair, body, before)) {
                throw new IllegalArgumentException(
                        "the list of pairs of the body in slot " + body + " is broken at " + pair);
            }
            linked++;
            before = pair;
            pair = pairs.nextOf(pair, body);
        }
    }

    private boolean isInListAfter(int pair, int body, int before) {
        if (pair < 0 || pair >= isPair.length || !isPair[pair]) {
            return false;
        }
        boolean isA = pairs.bodyA[pair] == body;
        return (isA || pairs.bodyB[pair] == body)
                && pairs.previous[2 * pair + (isA ? 0 : 1)] == before;
    }
}
