package rigibo.backend.rest;

import java.util.Arrays;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

/** Wakes a body and all that sleeps in touch with it, and with that, and so on. */
public final class Waking {

    private final DataStorage data;
    private final Bodies bodies;
    private final Pairs pairs;
    private int[] stack = new int[16];
    private int depth;

    /** Wakes bodies of this storage. */
    public Waking(DataStorage data) {
        this.data = data;
        bodies = data.bodies;
        pairs = data.pairs;
    }

    /** Wakes a body, whether it slept or not, and every sleeper in touch with it. */
    public void wake(int slot) {
        bodies.restartStillness(slot);
        push(slot);
        spread();
    }

    /** Wakes what touches a body that is about to go or change. */
    public void wakeNeighbours(int slot) {
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            int other = pairs.other(p, slot);
            if (pairs.touching[p] && bodies.type[other] == BodyType.DYNAMIC) {
                wake(other);
            }
        }
    }

    private void spread() {
        while (depth > 0) {
            int slot = stack[--depth];
            if (bodies.type[slot] != BodyType.DYNAMIC) {
                continue;
            }
            if (!bodies.awake[slot]) {
                bodies.awake[slot] = true;
                bodies.restartStillness(slot);
                data.roster.join(slot);
            }
            pushSleepers(slot);
        }
    }

    private void pushSleepers(int slot) {
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            int other = pairs.other(p, slot);
            if (pairs.touching[p]
                    && bodies.type[other] == BodyType.DYNAMIC
                    && !bodies.awake[other]) {
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
}
