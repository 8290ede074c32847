package rigibo.backend.flight;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Waking;

import java.util.Arrays;

/**
 * How far bodies of piles may leave their predicted paths because they are struck or about to
 * bounce. A flyer within reach of such a body joins the pile, a body of a pile within reach gets a
 * contact with it, a sleeper within reach wakes, and their own reach spreads in the same way. Gaps
 * on the way reduce a reach, and a struck body gets a share of it by its mass. Whenever the reach
 * of a body has grown, its neighbours are searched again.
 */
final class Disturbance {

    /** Called for a flyer within reach. */
    interface Joining {

        /** Makes a flyer part of a body's pile, at a time in s within a step of dt seconds. */
        void join(int flyer, int pileBody, double time, double dt);
    }

    /**
     * Factor by which a body's reach must grow before its neighbours are searched again. Without
     * it, the reach that equal bodies of elasticity 1 hand to and fro would grow by round-off for
     * ever.
     */
    private static final double GROWN = 1.05;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Trajectories paths;
    private final Bystanders bystanders;
    private final Waking waking;
    private final Joining joining;

    /** Null if joints are not declared. */
    private final JointStore joints;

    private final JointStops stops;
    private final JointDrives drives;

    /**
     * Bodies whose neighbours are still to be searched, in the order found; and those in progress.
     */
    private final Found waiting = new Found();

    private final Found present = new Found();
    private boolean[] isWaiting = new boolean[16];

    /** By body: its reach in this step, m. */
    private double[] reachOf = new double[16];

    Disturbance(
            DataStorage data,
            Trajectories paths,
            Bystanders bystanders,
            Waking waking,
            Joining joining) {
        bodies = data.bodies;
        pairs = data.pairs;
        joints = data.joints;
        stops = new JointStops(data);
        drives = new JointDrives(data);
        this.paths = paths;
        this.bystanders = bystanders;
        this.waking = waking;
        this.joining = joining;
    }

    /** Starts a step, with a reach of 0 for all bodies. */
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
        for (int i = 0; joints != null && i < joints.active.count; i++) {
            noteStruck(joints.active.numbers[i], dt);
            noteDriven(joints.active.numbers[i], dt);
        }
        spread(0, dt);
    }

    /** Records the reach that the bodies of a joint get by striking its stops in dt seconds. */
    private void noteStruck(int joint, double dt) {
        int a = joints.bodyA[joint];
        int b = joints.bodyB[joint];
        double reach = stops.reach(joint, dt);
        if (reach > 0) {
            double both = bodies.inverseMass[a] + bodies.inverseMass[b];
            note(a, reach * bodies.inverseMass[a] / both);
            note(b, reach * bodies.inverseMass[b] / both);
        }
    }

    /** Records the reach that a joint's spring and motor give its bodies in dt seconds. */
    private void noteDriven(int joint, double dt) {
        int a = joints.bodyA[joint];
        int b = joints.bodyB[joint];
        note(a, bystanders.unlessAllowed(a, drives.way(joint, a, dt)));
        note(b, bystanders.unlessAllowed(b, drives.way(joint, b, dt)));
    }

    /**
     * Records the reach that the bodies of a contact in a pile get by bouncing in {@code left} s.
     */
    private void noteBouncers(int pair, double left) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        if (!paths.isFlyer(a) && !paths.isFlyer(b)) {
            double reach = bystanders.reachOfBouncers(pair, left);
            note(a, reach);
            note(b, reach);
        }
    }

    /** Records a reach (m) of a body of a pile, if it is larger than the known one. */
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

    /** Spreads the recorded reaches: bodies within them join the pile at a time, s. */
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
                disturb(other, bystanders.reachLeft(p, other, reach, dt));
            } else if (bystanders.isWithinReach(p, reach, time, dt - time)) {
                double left = bystanders.reachLeft(p, other, reach, dt);
                if (flies) {
                    joining.join(other, slot, time, dt);
                    // Joining measures the contact only for the predicted motions; this body may go
                    // farther.
                    bystanders.isWithinReach(p, reach, time, dt - time);
                    noteBouncersOf(other, dt - time);
                }
                disturb(other, left);
            }
        }
        if (joints != null) {
            disturbJoined(slot, reach);
        }
    }

    /** Records the reach (m) that a neighbour gets; a sleeper wakes, with all that it touches. */
    private void disturb(int slot, double reach) {
        if (reach > 0 && waking.isAsleep(slot)) {
            waking.wakeIntoPile(slot);
        }
        note(slot, reach);
    }

    /**
     * Hands the reach of a body on to those that are joined to it. They become no faster than its
     * energy makes both of them. So contacts, which keep to that energy, too, and joints cannot
     * hand a reach round in circles in which it grows.
     */
    private void disturbJoined(int slot, double reach) {
        for (int j = joints.firstOf(slot); j != JointStore.NONE; j = joints.nextOf(j, slot)) {
            if (joints.hasRows(bodies, j)) {
                int other = joints.other(j, slot);
                double lightness = bodies.inverseMass[other];
                double share = lightness / (lightness + bodies.inverseMass[slot]);
                note(other, Math.sqrt(share) * reach);
            }
        }
    }

    /**
     * Records the reaches by the impacts of a flyer that just joined, if it did, in the {@code
     * left} seconds of the step. A fast flyer that joins because of a slow neighbour still strikes
     * it, and sends it farther than it would go by itself; one whose bounces on a floor end may
     * strike what lies there.
     */
    void noteBouncersOf(int joined, double left) {
        if (!bodies.isDynamic(joined) || paths.isFlyer(joined)) {
            return;
        }
        for (int p = bodies.firstPair[joined]; p != Pairs.NONE; p = pairs.nextOf(p, joined)) {
            if (pairs.points[p] > 0) {
                noteBouncers(p, left);
            }
        }
    }
}
