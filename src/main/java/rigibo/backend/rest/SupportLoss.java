package rigibo.backend.rest;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Waking;

import java.util.Arrays;

/**
 * Who wakes when a body goes: all that leaned on it, and of what it stood on whatever might not be
 * steady without it. A box in the middle of a tower sleeps on when the upper half is taken away; a
 * seesaw that loses a weight does not.
 *
 * <p>A sleeper is steady whatever it carries if its centre of mass and every place where something
 * stands on it lie above the span of its supports, and if the same holds for what supports it. Each
 * body is looked at once per loss, so that a loss takes time linear in the contacts, however many
 * ways lead down a pile.
 */
public final class SupportLoss {

    /** Contacts this upright (cosine to gravity) carry; others hold from the side. */
    private static final double UPRIGHT = 0.999;

    private final DataStorage data;
    private final Bodies bodies;
    private final Pairs pairs;
    private final Waking waking;

    /**
     * Sleepers whose steadiness is asked for by the one that lost a neighbour, itself the first.
     */
    private final Found asked = new Found();

    /** For each body the loss in which it was last asked about, and the number of this one. */
    private int[] askedIn = new int[16];

    private int loss;

    /** Contacts looked at so far, for tests of how much work a loss is. */
    private long contactsLookedAt;

    /** Gravity's direction for the body looked at. */
    private double downX;

    private double downY;

    /** The span of its supports and of what it must stand under, m across gravity. */
    private double supportLeft;

    private double supportRight;
    private double loadLeft;
    private double loadRight;

    /** Waking in this storage. */
    public SupportLoss(DataStorage data, Waking waking) {
        this.data = data;
        bodies = data.bodies;
        pairs = data.pairs;
        this.waking = waking;
    }

    /** Wakes who must, before a body goes. */
    public void wakeNeighbours(int going) {
        // Waking spreads through sleepers; it is not to spread through the one that goes.
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
            // It was about to sleep, perhaps: what it does now has to be seen first.
            bodies.restartStillness(slot);
        } else if (!(isUnder(pair, slot) && isSteady(slot))) {
            waking.wake(slot);
        }
    }

    /** Whether a body of a pair lies under the other, by its own gravity. */
    private boolean isUnder(int pair, int body) {
        findDown(body);
        return sideOf(pair, body) < -UPRIGHT;
    }

    /** Cosine between gravity and the normal out of the body: 1 where the other supports it. */
    private double sideOf(int pair, int body) {
        double sign = pairs.bodyA[pair] == body ? 1 : -1;
        return sign * (pairs.normalX[pair] * downX + pairs.normalY[pair] * downY);
    }

    /** Without weight nothing is down: what is not a number is neither under nor above anything. */
    private void findDown(int body) {
        double ax = bodies.accelerationX[body];
        double ay = bodies.accelerationY[body];
        double length = Math.sqrt(ax * ax + ay * ay);
        downX = ax / length;
        downY = ay / length;
    }

    /**
     * Whether a sleeper and all that supports it are steady. Who was asked about before in this
     * loss is steady: else it has woken, with everyone that stands on it.
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
     * Asks about every dynamic support; false where one is awake, or is pulled another way:
     * relieved of its load, it might rise.
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

    /** Measures both spans; false where something holds from the side or moves. */
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

    /** With those that waking looked at. */
    long contactsLookedAt() {
        return contactsLookedAt + waking.contactsLookedAt();
    }
}
