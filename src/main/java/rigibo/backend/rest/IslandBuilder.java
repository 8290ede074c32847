package rigibo.backend.rest;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Roster;

/**
 * Groups piled bodies into islands by union-find over their pairs. Static and kinematic bodies join
 * nothing: two stacks on one floor are two islands. Islands are numbered by their first body in the
 * roster, and bodies and pairs keep their order within an island.
 */
public final class IslandBuilder {

    private static final int UNNUMBERED = -1;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Roster roster;
    private final Islands islands;
    private int[] parent = new int[16];
    private int[] number = new int[16];

    /** A builder of the islands of a storage. */
    public IslandBuilder(DataStorage data) {
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
        numberIslands();
        countAndFill();
    }

    /** Whether a pair belongs to a pile: near, and none of its dynamic bodies is in flight. */
    private boolean isPilePair(int pair) {
        if (pairs.points[pair] == 0) {
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
            int rootA = root(a);
            int rootB = root(b);
            // The lower slot leads, so that the shape of the forest cannot depend on pair order.
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

    /** The leader of a body's group; halves the path on the way. */
    private int root(int slot) {
        int at = slot;
        while (parent[at] != at) {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        return at;
    }
}
