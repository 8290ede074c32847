package rigibo.backend.storage;

import rigibo.backend.setup.BodyType;

import java.util.Arrays;

/** Wakes a body and all sleeping bodies that are connected with it by contacts or joints. */
public final class Waking {

    private final DataStorage data;
    private final Bodies bodies;
    private final Pairs pairs;
    private int[] stack = new int[16];
    private int depth;

    private long contactsLookedAt;

    /** Wakes bodies of a storage. */
    public Waking(DataStorage data) {
        this.data = data;
        bodies = data.bodies;
        pairs = data.pairs;
    }

    /** Wakes a body, whether it sleeps or not, and every sleeping body connected with it. */
    public void wake(int slot) {
        bodies.restartStillness(slot);
        if (bodies.type[slot] == BodyType.STATIC || bodies.isDisabled(slot)) {
            return;
        }
        if (isAsleep(slot)) {
            rouse(slot);
        }
        pushSleepers(slot);
        spread();
    }

    /** Wakes the neighbours of a body that is about to be removed or changed. */
    public void wakeNeighbours(int slot) {
        for (int p = bodies.firstPairOf(slot); p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            int other = pairs.other(p, slot);
            if (pairs.touching[p] && bodies.isDynamic(other)) {
                wake(other);
            }
        }
        if (data.joints != null) {
            wakeJoined(slot);
        }
    }

    private void wakeJoined(int slot) {
        JointStore joints = data.joints;
        for (int j = joints.firstOf(slot); j != JointStore.NONE; j = joints.nextOf(j, slot)) {
            if (bodies.isDynamic(joints.other(j, slot))) {
                wake(joints.other(j, slot));
            }
        }
    }

    /**
     * Wakes a sleeping body within a step, with all bodies connected with it. They join as a pile,
     * and their pairs become active. Their manifolds still hold, since nothing there has moved
     * after the step in which they fell asleep; the next step measures them again.
     */
    public void wakeIntoPile(int slot) {
        int first = data.roster.awakeCount;
        wake(slot);
        for (int i = first; i < data.roster.awakeCount; i++) {
            int woken = data.roster.awake[i];
            bodies.piled[woken] = true;
            bodies.pileTime[woken] = 0;
            bodies.keepStart(woken);
            if (bodies.turns()) {
                bodies.keepStartAngle(woken);
            }
            for (int p = bodies.firstPair[woken]; p != Pairs.NONE; p = pairs.nextOf(p, woken)) {
                pairs.activateLate(p);
            }
        }
    }

    /**
     * Wakes a sleeper that the other body of a pair, in a pile or driven, is about to touch within
     * dt seconds.
     */
    public void wakeWhatIsHit(int pair, double dt) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        boolean hitsB = isPushing(a) && isAsleep(b);
        boolean hitsA = isPushing(b) && isAsleep(a);
        if ((hitsA || hitsB) && pairs.points[pair] > 0) {
            double closing = -dt * slowestParting(pair);
            if (pairs.gap(pair) <= closing) {
                wakeIntoPile(hitsA ? a : b);
            }
        }
    }

    private boolean isPushing(int slot) {
        return bodies.isDriven(slot) || bodies.isDynamic(slot) && bodies.piled[slot];
    }

    /** Whether a body sleeps. */
    public boolean isAsleep(int slot) {
        return bodies.isDynamic(slot) && !bodies.awake[slot];
    }

    /** Least parting speed of a pair's points, m/s; negative if one of them closes. */
    private double slowestParting(int pair) {
        double slowest = Double.POSITIVE_INFINITY;
        for (int point = 2 * pair; point < 2 * pair + pairs.points[pair]; point++) {
            slowest = Math.min(slowest, PointSpeeds.parting(bodies, pairs, pair, point));
        }
        return slowest;
    }

    private void spread() {
        while (depth > 0) {
            int slot = stack[--depth];
            // Several neighbours may have pushed it; only the first visit has anything to spread.
            if (!bodies.awake[slot]) {
                rouse(slot);
                pushSleepers(slot);
            }
        }
    }

    private void rouse(int sleeper) {
        bodies.awake[sleeper] = true;
        bodies.restartStillness(sleeper);
        data.roster.join(sleeper);
    }

    private void pushSleepers(int slot) {
        for (int p = bodies.firstPairOf(slot); p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            contactsLookedAt++;
            int other = pairs.other(p, slot);
            if (pairs.touching[p] && isAsleep(other)) {
                push(other);
            }
        }
        if (data.joints != null) {
            pushJoined(slot);
        }
    }

    private void pushJoined(int slot) {
        JointStore joints = data.joints;
        for (int j = joints.firstOf(slot); j != JointStore.NONE; j = joints.nextOf(j, slot)) {
            int other = joints.other(j, slot);
            if (joints.hasRows(bodies, j) && isAsleep(other)) {
                push(other);
            }
        }
    }

    private void push(int slot) {
        if (depth == stack.length) {
            stack = Arrays.copyOf(stack, 2 * depth);
        }
        stack[depth++] = slot;
    }

    /** Number of contacts visited so far: the work of all wake-ups. */
    public long contactsLookedAt() {
        return contactsLookedAt;
    }
}
