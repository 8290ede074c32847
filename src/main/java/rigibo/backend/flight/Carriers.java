package rigibo.backend.flight;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Roster;

import java.util.Arrays;

/**
 * The velocity of the driven body that carries a pile, directly or through bodies that may touch
 * within the step. Speeds in the pile are measured relative to it, so that a pile on a floor in
 * steady translation behaves as on a floor at rest. The velocity is 0 where no translating body
 * carries the pile, or where it lies on fixed or driven bodies with different velocities.
 */
final class Carriers {

    private final Bodies bodies;
    private final Pairs pairs;
    private final Roster roster;

    /** By body: velocity of its carrier, m/s; 0 if none is driven. */
    private double[] velocityX = new double[16];

    private double[] velocityY = new double[16];

    /** By body: whether this step has visited it. */
    private boolean[] isSeen = new boolean[16];

    private final Found carried = new Found();

    /** Whether any body has a moving carrier. */
    private boolean isAny;

    /** Whether all fixed and driven bodies that the present pile touches have the same velocity. */
    private boolean areAlike;

    Carriers(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
        roster = data.roster;
    }

    /** Finds the carriers of all bodies at the start of a step. */
    void begin() {
        int capacity = bodies.type.length;
        if (velocityX.length < capacity) {
            velocityX = new double[capacity];
            velocityY = new double[capacity];
            isSeen = new boolean[capacity];
        }
        carried.reserve(capacity);
        if (isAny) {
            Arrays.fill(velocityX, 0);
            Arrays.fill(velocityY, 0);
            Arrays.fill(isSeen, false);
            isAny = false;
        }
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDriven(slot) && isMoving(slot) && bodies.spinOf(slot) == 0) {
                isAny = true;
                carry(slot);
            }
        }
    }

    private boolean isMoving(int slot) {
        return bodies.velocityX[slot] != 0 || bodies.velocityY[slot] != 0;
    }

    /** Finds the piles that touch a driven body, one after the other. */
    private void carry(int carrier) {
        for (int p = bodies.firstPair[carrier]; p != Pairs.NONE; p = pairs.nextOf(p, carrier)) {
            carried.clear();
            areAlike = true;
            meet(p, pairs.other(p, carrier), carrier);
            for (int i = 0; i < carried.count; i++) {
                int slot = carried.numbers[i];
                for (int q = bodies.firstPair[slot]; q != Pairs.NONE; q = pairs.nextOf(q, slot)) {
                    meet(q, pairs.other(q, slot), carrier);
                }
            }
            for (int i = 0; areAlike && i < carried.count; i++) {
                velocityX[carried.numbers[i]] = bodies.velocityX[carrier];
                velocityY[carried.numbers[i]] = bodies.velocityY[carrier];
            }
        }
    }

    private void meet(int pair, int slot, int carrier) {
        if (pairs.points[pair] == 0) {
            return;
        }
        if (!bodies.isDynamic(slot)) {
            areAlike &= movesAs(slot, carrier);
        } else if (bodies.awake[slot] && !isSeen[slot]) {
            isSeen[slot] = true;
            carried.add(slot);
        }
    }

    /** Whether a fixed or driven body has the same velocity as the carrier. */
    private boolean movesAs(int slot, int carrier) {
        return bodies.velocityX[slot] == bodies.velocityX[carrier]
                && bodies.velocityY[slot] == bodies.velocityY[carrier]
                && bodies.spinOf(slot) == 0;
    }

    /** Gives a body that joins a pile within the step the carrier of the body it joins. */
    void join(int flyer, int pileBody) {
        velocityX[flyer] = velocityX[pileBody];
        velocityY[flyer] = velocityY[pileBody];
    }

    double velocityX(int slot) {
        return velocityX[slot];
    }

    double velocityY(int slot) {
        return velocityY[slot];
    }
}
