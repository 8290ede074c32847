package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.Pairs;

import java.util.Arrays;

/**
 * The order in which passes take the contacts of an island: colour by colour. No two contacts of
 * one colour share a body that impulses move, so that a processor can work on several at once, and
 * cores could share them with the same bits as result.
 *
 * <p>In the order of the island's pairs, each contact gets the first colour that neither of its
 * bodies has yet, so that the colours depend on the island alone. Contacts with immovable bodies
 * come after all others, in colours of their own: the error that a pass leaves is then between
 * movable bodies, and none sinks into the floor.
 */
final class Colours {

    /** Number of colours that are chosen by which are free; further ones are given out in turn. */
    private static final int FEW = 64;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Islands islands;

    /** The island's pairs in the order of their colours. */
    int[] order = new int[16];

    /** By colour: its end in the order. */
    int[] end = new int[16];

    int count;

    /** Start of contacts with immovable bodies in the order. */
    int groundStart;

    /** First colour of contacts with immovable bodies. */
    int groundColour;

    /** By pair of the island: its colour. */
    private int[] colour = new int[16];

    /** By slot: a bit for each of the first colours that the body has. */
    private long[] taken = new long[16];

    /** By slot: number of colours beyond the first ones. */
    private int[] beyond = new int[16];

    Colours(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
        islands = data.islands;
    }

    /** Orders an island's pairs. */
    void find(int island) {
        int pairCount = islands.pairStart[island + 1] - islands.pairStart[island];
        reserve(pairCount);
        count = 0;
        colour(island, false);
        groundColour = count;
        colour(island, true);
        sort(islands.pairStart[island], pairCount);
        groundStart = groundColour > 0 ? end[groundColour - 1] : 0;
    }

    /** Gives colours to the contacts between movable bodies, or to those with immovable ones. */
    private void colour(int island, boolean ofGround) {
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            taken[islands.bodies[i]] = 0;
            beyond[islands.bodies[i]] = 0;
        }
        int first = count;
        int from = islands.pairStart[island];
        for (int i = from; i < islands.pairStart[island + 1]; i++) {
            int a = pairs.bodyA[islands.pairs[i]];
            int b = pairs.bodyB[islands.pairs[i]];
            boolean isOfGround = !bodies.isDynamic(a) || !bodies.isDynamic(b);
            if (isOfGround == ofGround) {
                int own = bodies.isDynamic(a) ? a : b;
                colour[i - from] = first + take(own, bodies.isDynamic(b) ? b : own);
                count = Math.max(count, colour[i - from] + 1);
            }
        }
    }

    /** Takes the first colour that neither of two bodies has. */
    private int take(int a, int b) {
        int spare = Long.numberOfTrailingZeros(~(taken[a] | taken[b]));
        if (spare < FEW) {
            taken[a] |= 1L << spare;
            taken[b] |= 1L << spare;
            return spare;
        }
        int next = Math.max(beyond[a], beyond[b]);
        beyond[a] = next + 1;
        beyond[b] = next + 1;
        return FEW + next;
    }

    /** Sorts by colour, in the given order within each colour. */
    private void sort(int from, int pairCount) {
        Arrays.fill(end, 0, count, 0);
        for (int i = 0; i < pairCount; i++) {
            end[colour[i]]++;
        }
        // Holds each colour's size, then its start and, once it is filled, its end.
        int start = 0;
        for (int i = 0; i < count; i++) {
            start += end[i];
            end[i] = start - end[i];
        }
        for (int i = 0; i < pairCount; i++) {
            order[end[colour[i]]++] = islands.pairs[from + i];
        }
    }

    private void reserve(int pairCount) {
        if (taken.length < bodies.type.length) {
            taken = new long[bodies.type.length];
            beyond = new int[bodies.type.length];
        }
        if (order.length < pairCount) {
            order = new int[2 * pairCount];
            colour = new int[2 * pairCount];
            end = new int[2 * pairCount];
        }
    }
}
