package rigibo.backend.rest;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Roster;

/**
 * Groups piled bodies into islands by union-find over their pairs and joints. Static and kinematic
 * bodies do not connect islands: two stacks on one floor are two islands. Islands are numbered in
 * the order of their first body in the roster; bodies and pairs keep their order within an island.
 */
public final class IslandBuilder {

    private static final int UNNUMBERED = -1;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Roster roster;
    private final Islands islands;
    private final DataStorage data;
    private int[] parent = new int[16];
    private int[] number = new int[16];

    /** A builder of the islands of a storage. */
    public IslandBuilder(DataStorage data) {
        this.data = data;
        bodies = data.bodies;
        pairs = data.pairs;
        roster = data.roster;
        islands = data.islands;
    }

    /** Builds the islands of this step's piled bodies. */
    public void build() {
        startAlone();
        for (int i = 0; i < pairs.activeCount; i++) {
            uniteBodiesOf(pairs.active[i]);
        }
        if (data.joints != null) {
            uniteJoined(data.joints);
        }
        numberIslands();
        countAndFill();
        if (data.hasAssemblies()) {
            fillJoints(data.jointsOrNone());
        } else {
            islands.jointStart = null;
        }
    }

    private void uniteJoined(JointStore joints) {
        for (int i = 0; i < joints.active.count; i++) {
            int joint = joints.active.numbers[i];
            int gears = joints.firstGeared[joint];
            unite(joints.bodyA[joint], joints.bodyB[joint]);
            if (gears != JointStore.NONE) {
                unite(joints.bodyA[joint], joints.bodyA[gears]);
                unite(joints.bodyB[joint], joints.bodyA[joints.secondGeared[joint]]);
            }
        }
    }

    /** Counting sort of joints by island. */
    private void fillJoints(JointStore joints) {
        islands.reserveJoints(islands.count, joints.active.count);
        for (int i = 0; i < joints.active.count; i++) {
            islands.jointStart[islandOf(joints, joints.active.numbers[i]) + 2]++;
        }
        for (int i = 1; i <= islands.count; i++) {
            islands.jointStart[i + 1] += islands.jointStart[i];
        }
        // Filling an island moves its start to its end, which is the start of the next one.
        for (int i = 0; i < joints.active.count; i++) {
            int joint = joints.active.numbers[i];
            islands.joints[islands.jointStart[islandOf(joints, joint) + 1]++] = joint;
        }
    }

    private int islandOf(JointStore joints, int joint) {
        int a = joints.bodyA[joint];
        return number[bodies.isDynamic(a) ? a : joints.bodyB[joint]];
    }

    /** Whether a pair belongs to a pile: near, and none of its dynamic bodies is in flight. */
    private boolean isPilePair(int pair) {
        if (pairs.points[pair] == 0 && !pairs.isAwaited(pair)) {
            return false;
        }
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        boolean dynamicA = bodies.isDynamic(a);
        boolean dynamicB = bodies.isDynamic(b);
        return (!dynamicA || bodies.piled[a] && bodies.awake[a])
                && (!dynamicB || bodies.piled[b] && bodies.awake[b]);
    }

    private void startAlone() {
        if (parent.length < bodies.type.length) {
            parent = new int[bodies.type.length];
            number = new int[bodies.type.length];
        }
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            parent[slot] = slot;
            number[slot] = UNNUMBERED;
        }
    }

    private void uniteBodiesOf(int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        if (bodies.isDynamic(a) && bodies.isDynamic(b) && isPilePair(pair)) {
            unite(a, b);
        }
    }

    private void unite(int a, int b) {
        if (bodies.isDynamic(a) && bodies.isDynamic(b)) {
            int rootA = root(a);
            int rootB = root(b);
            // The lower slot becomes the root, so that roots do not depend on the order of pairs.
            parent[Math.max(rootA, rootB)] = Math.min(rootA, rootB);
        }
    }

    private void numberIslands() {
        islands.count = 0;
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (isPiled(slot)) {
                int leader = root(slot);
                if (number[leader] == UNNUMBERED) {
                    number[leader] = islands.count++;
                }
                number[slot] = number[leader];
            }
        }
    }

    /** Counting sort of bodies and pairs by island. */
    private void countAndFill() {
        islands.reserve(islands.count, roster.awakeCount, pairs.activeCount);
        for (int i = 0; i < roster.awakeCount; i++) {
            if (isPiled(roster.awake[i])) {
                islands.bodyStart[number[roster.awake[i]] + 1]++;
            }
        }
        for (int i = 0; i < pairs.activeCount; i++) {
            if (isPilePair(pairs.active[i])) {
                islands.pairStart[islandOf(pairs.active[i]) + 1]++;
            }
        }
        for (int i = 0; i < islands.count; i++) {
            islands.bodyStart[i + 1] += islands.bodyStart[i];
            islands.pairStart[i + 1] += islands.pairStart[i];
        }
        fill();
    }

    private void fill() {
        islands.rewind();
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (isPiled(slot)) {
                islands.bodies[islands.bodyFill[number[slot]]++] = slot;
            }
        }
        for (int i = 0; i < pairs.activeCount; i++) {
            int pair = pairs.active[i];
            if (isPilePair(pair)) {
                int island = islandOf(pair);
                islands.pairs[islands.pairFill[island]++] = pair;
            }
        }
    }

    private int islandOf(int pair) {
        int a = pairs.bodyA[pair];
        return number[bodies.isDynamic(a) ? a : pairs.bodyB[pair]];
    }

    private boolean isPiled(int slot) {
        return bodies.isDynamic(slot) && bodies.piled[slot];
    }

    /** The root of a body's group; halves the path to it (path halving). */
    private int root(int slot) {
        int at = slot;
        while (parent[at] != at) {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        return at;
    }
}
