package rigibo.backend.storage;

/**
 * Keeps the contact reports right for pairs whose bodies have both stopped. No step looks at such a
 * pair again, so its columns stay as its last step left them; without a correction every later step
 * would report that the contact just began, or just ended.
 */
public final class StillContacts {

    private final Bodies bodies;
    private final Pairs pairs;

    /** Shapes, two by two, of the stopped pairs whose end this step reports. */
    private final Found parted = new Found();

    StillContacts(Bodies bodies, Pairs pairs) {
        this.bodies = bodies;
        this.pairs = pairs;
    }

    /**
     * Corrects the pairs that were active in the last step and have stopped since. It runs before a
     * step lists its active pairs.
     */
    public void settle() {
        settleParted();
        for (int i = 0; i < pairs.activeCount; i++) {
            settle(pairs.active[i]);
        }
    }

    private void settleParted() {
        for (int i = 0; i < parted.count; i += 2) {
            int pair = pairs.index.find(parted.numbers[i], parted.numbers[i + 1]);
            if (pair != PairIndex.ABSENT && isStill(pair)) {
                pairs.touchedBefore[pair] = pairs.touching[pair];
            }
        }
        parted.clear();
    }

    private void settle(int pair) {
        if (pairs.bodyA[pair] == Pairs.NONE || !isStill(pair)) {
            return;
        }
        pairs.touchedBefore[pair] = pairs.touched(pair);
        pairs.impacts[pair] = 0;
        if (pairs.touchedBefore[pair] && !pairs.touching[pair]) {
            parted.add(pairs.shapeA(pair));
            parted.add(pairs.shapeB(pair));
        }
    }

    private boolean isStill(int pair) {
        return !bodies.isMoved(pairs.bodyA[pair]) && !bodies.isMoved(pairs.bodyB[pair]);
    }
}
