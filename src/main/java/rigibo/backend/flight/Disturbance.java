package rigibo.backend.flight;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.Pairs;

import java.util.Arrays;

/**
 * How far bodies of piles may leave the paths that flyers expect of them, because they are struck
 * or about to bounce. What such a body may reach becomes part of the pile, or a contact, and so
 * does what that may reach in its turn. A reach is used up by the gaps on its way, and a body that
 * is struck gets its share of it by mass. The neighbours of a body are looked at again whenever its
 * reach has grown.
 */
final class Disturbance {

    /** What a flyer that is within reach does. */
    interface Joining {

        /** Makes a flyer part of a body's pile, at a time in s within a step of dt seconds. */
        void join(int flyer, int pileBody, double time, double dt);
    }

    /**
     * Factor by which a body's reach has to grow for its neighbours to be looked at again: without
     * it, what equal bodies of full elasticity hand to and fro would grow by round-off for ever.
     */
    private static final double GROWN = 1.05;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Trajectories paths;
    private final Bystanders bystanders;
    private final Joining joining;

    /**
     * Bodies whose neighbours are to be looked at, in the order found; and those being looked at.
     */
    private final Found waiting = new Found();

    private final Found present = new Found();
    private boolean[] isWaiting = new boolean[16];

    /** For each body how far it may get in this step from where it is expected, m. */
    private double[] reachOf = new double[16];

    Disturbance(DataStorage data, Trajectories paths, Bystanders bystanders, Joining joining) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.paths = paths;
        this.bystanders = bystanders;
        this.joining = joining;
    }

    /** Begins a step: all are where they are expected. */
    void begin() {
        int capacity = bodies.type.length;
        if (reachOf.length < capacity) {
            reachOf = new double[capacity];
            isWaiting = new boolean[capacity];
        }
        waiting.reserve(capacity);
        present.reserve(capacity);
        Arrays.fill(reachOf, 0, bodies.slots.high, 0);
    }

    /** Spreads from all contacts of piles whose bodies strike each other in a step. */
    void spreadBouncers(double dt) {
        int count = pairs.activeCount;
        for (int i = 0; i < count; i++) {
            if (pairs.points[pairs.active[i]] > 0) {
                noteBouncers(pairs.active[i], dt);
            }
        }
        spread(0, dt);
    }

    /** Notes how far the bodies of a contact of a pile get in some seconds by bouncing. */
    void noteBouncers(int pair, double left) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        if (!paths.isFlyer(a) && !paths.isFlyer(b)) {
            double reach = bystanders.reachOfBouncers(pair, left);
            note(a, reach);
            note(b, reach);
        }
    }

    /** Notes how far (m) a body of a pile may get, if that is farther than was known. */
    void note(int slot, double reach) {
        boolean isPiled = bodies.isDynamic(slot) && bodies.awake[slot] && !paths.isFlyer(slot);
        if (isPiled && reach > GROWN * reachOf[slot]) {
            reachOf[slot] = reach;
            if (!isWaiting[slot]) {
                isWaiting[slot] = true;
                waiting.add(slot);
            }
        }
    }

    /** Lets the bodies that the noted ones may reach in the rest of a step join at a time. */
    void spread(double time, double dt) {
        while (waiting.count > 0) {
            takeWaiting();
            for (int i = 0; i < present.count; i++) {
                disturbNeighbours(present.numbers[i], time, dt);
            }
        }
    }

    private void takeWaiting() {
        present.clear();
        for (int i = 0; i < waiting.count; i++) {
            isWaiting[waiting.numbers[i]] = false;
            present.add(waiting.numbers[i]);
        }
        waiting.clear();
    }

    private void disturbNeighbours(int slot, double time, double dt) {
        double reach = reachOf[slot];
        bystanders.lookRound(slot, time, reach);
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            int other = pairs.other(p, slot);
            boolean flies = paths.isFlyer(other);
            if (!flies && pairs.points[p] > 0) {
                note(other, bystanders.reachLeft(p, other, reach, dt));
            } else if (bystanders.isWithinReach(p, reach, time, dt - time)) {
                double left = bystanders.reachLeft(p, other, reach, dt);
                if (flies) {
                    joining.join(other, slot, time, dt);
                    // Whoever joins is measured against the pile for the ways both are expected to
                    // go, and this one goes farther.
                    bystanders.isWithinReach(p, reach, time, dt - time);
                    noteBouncersOf(other, dt - time);
                }
                note(other, left);
            }
        }
    }

    /**
     * A fast flyer that joins for a slow neighbour's sake strikes it all the same, and what it
     * strikes goes farther than the neighbour would have gone by itself.
     */
    private void noteBouncersOf(int joined, double left) {
        for (int p = bodies.firstPair[joined]; p != Pairs.NONE; p = pairs.nextOf(p, joined)) {
            if (pairs.points[p] > 0) {
                noteBouncers(p, left);
            }
        }
    }
}
