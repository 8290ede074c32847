package rigibo.backend.rest;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Waking;

import java.util.Arrays;

/**
 * Wakes neighbours when a body is removed: all bodies that leaned on it, and those bodies below it
 * that might not be steady without its load. A box in the middle of a tower sleeps on when the
 * upper half is taken away; a seesaw that loses a weight wakes.
 *
 * <p>A sleeper is steady under any load if its centre of mass and every point where another body
 * stands on it lie above the span of its supports, and if its supports are steady too. Each body is
 * tested once per removal, so that the time is linear in the number of contacts however many paths
 * lead down through the pile.
 */
public final class SupportLoss {

    /** Cosine between normal and gravity from which on a contact carries; others hold sideways. */
    private static final double UPRIGHT = 0.999;

    private final DataStorage data;
    private final Bodies bodies;
    private final Pairs pairs;
    private final Waking waking;

    /** Sleepers to be tested: first the body that lost a neighbour, then those that support it. */
    private final Found asked = new Found();

    /** By body: number of the removal in which it was last tested. */
    private int[] askedIn = new int[16];

    /** Number of the present removal. */
    private int loss;

    /** Contacts read so far: tests bound the work of a removal by it. */
    private long contactsLookedAt;

    /** Direction of gravity for the body being tested. */
    private double downX;

    private double downY;

    /** Span of the body's supports, m across gravity. */
    private double supportLeft;

    private double supportRight;

    /** Span of its centre of mass and of the loads on it, m across gravity. */
    private double loadLeft;

    private double loadRight;

    /** Waking of the bodies of a storage. */
    public SupportLoss(DataStorage data, Waking waking) {
        this.data = data;
        bodies = data.bodies;
        pairs = data.pairs;
        this.waking = waking;
    }

    /** Wakes the neighbours that must wake, before a body is removed. */
    public void wakeNeighbours(int going) {
        // Waking spreads through sleepers, but must not spread through the body being removed.
        bodies.awake[going] = true;
        loss++;
        if (askedIn.length < bodies.type.length) {
            askedIn = Arrays.copyOf(askedIn, bodies.type.length);
        }
        for (int p = bodies.firstPairOf(going); p != Pairs.NONE; p = pairs.nextOf(p, going)) {
            contactsLookedAt++;
            int other = pairs.other(p, going);
            if (pairs.touching[p] && bodies.isDynamic(other)) {
                loseNeighbour(p, other);
            }
        }
    }

    private void loseNeighbour(int pair, int slot) {
        if (bodies.awake[slot]) {
            // It may have been about to sleep: its time at rest starts again.
            bodies.restartStillness(slot);
        } else if (!(isUnder(pair, slot) && isSteady(slot))) {
            waking.wake(slot);
        }
    }

    /** Whether a body of a pair lies below the other, along its own gravity. */
    private boolean isUnder(int pair, int body) {
        findDown(body);
        return sideOf(pair, body) < -UPRIGHT;
    }

    /** Cosine between gravity and the normal out of the body: 1 where the other supports it. */
    private double sideOf(int pair, int body) {
        double sign = pairs.bodyA[pair] == body ? 1 : -1;
        return sign * (pairs.normalX[pair] * downX + pairs.normalY[pair] * downY);
    }

    /** Without weight the direction is NaN, which compares as neither below nor above. */
    private void findDown(int body) {
        double ax = bodies.accelerationX[body];
        double ay = bodies.accelerationY[body];
        double length = Math.sqrt(ax * ax + ay * ay);
        downX = ax / length;
        downY = ay / length;
    }

    /**
     * Whether a sleeper and all that supports it are steady. A body already tested in this removal
     * is steady; otherwise it has woken, together with everything that stands on it.
     */
    private boolean isSteady(int body) {
        asked.clear();
        ask(body);
        for (int i = 0; i < asked.count; i++) {
            if (!isSteadyOnItsSupports(asked.numbers[i]) || !askSupportsOf(asked.numbers[i])) {
                return false;
            }
        }
        return true;
    }

    private void ask(int body) {
        if (askedIn[body] != loss) {
            askedIn[body] = loss;
            asked.add(body);
        }
    }

    private boolean isSteadyOnItsSupports(int body) {
        if (data.isJoined(body) || bodies.isHeldByAxis(body)) {
            return false;
        }
        findDown(body);
        if (!measure(body)) {
            return false;
        }
        double slack = PairTolerances.INVISIBLE_LIFT * bodies.smallestWidth[body];
        return loadLeft >= supportLeft - slack && loadRight <= supportRight + slack;
    }

    /**
     * Adds every dynamic support to the tests. Returns false if one is awake, or is pulled in
     * another direction, since it could rise once relieved of its load.
     */
    private boolean askSupportsOf(int body) {
        for (int p = bodies.firstPair[body]; p != Pairs.NONE; p = pairs.nextOf(p, body)) {
            contactsLookedAt++;
            int other = pairs.other(p, body);
            findDown(body);
            boolean supports = pairs.touching[p] && sideOf(p, body) > 0;
            if (supports && bodies.isDynamic(other)) {
                if (bodies.awake[other] || !isUnder(p, other)) {
                    return false;
                }
                ask(other);
            }
        }
        return true;
    }

    /** Measures both spans; returns false if a contact holds sideways or a neighbour moves. */
    private boolean measure(int body) {
        supportLeft = Double.POSITIVE_INFINITY;
        supportRight = Double.NEGATIVE_INFINITY;
        loadLeft = across(bodies.x[body], bodies.y[body]);
        loadRight = loadLeft;
        for (int p = bodies.firstPair[body]; p != Pairs.NONE; p = pairs.nextOf(p, body)) {
            contactsLookedAt++;
            if (pairs.touching[p] && !take(p, body)) {
                return false;
            }
        }
        return true;
    }

    private boolean take(int pair, int body) {
        double side = sideOf(pair, body);
        if (Math.abs(side) < UPRIGHT || bodies.isDriven(pairs.other(pair, body))) {
            return false;
        }
        for (int point = 2 * pair; point < 2 * pair + pairs.points[pair]; point++) {
            double at = across(pairs.pointX[point], pairs.pointY[point]);
            if (side > 0) {
                supportLeft = Math.min(supportLeft, at);
                supportRight = Math.max(supportRight, at);
            } else {
                loadLeft = Math.min(loadLeft, at);
                loadRight = Math.max(loadRight, at);
            }
        }
        return true;
    }

    private double across(double x, double y) {
        return x * -downY + y * downX;
    }

    /** Contacts read so far, those of waking included. */
    long contactsLookedAt() {
        return contactsLookedAt + waking.contactsLookedAt();
    }
}
