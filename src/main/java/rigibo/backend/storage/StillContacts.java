package rigibo.backend.storage;

/**
 * What is told of pairs whose bodies have both come to stand still. Nobody looks at them again, so
 * they go on as their last step left them; they must not be told step by step that they just began,
 * or just ended.
 */
public final class StillContacts {

    private final Bodies bodies;
    private final Pairs pairs;

    /** The shapes, two by two, of still pairs whose end is told of this step. */
    private final Found parted = new Found();

    StillContacts(Bodies bodies, Pairs pairs) {
        this.bodies = bodies;
        this.pairs = pairs;
    }

    /** Before a step lists its active pairs: of those of the last step some are still by now. */
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
