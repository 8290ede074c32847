package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.Pairs;

/**
 * The frame of the bodies that carry an island. The laws are the same in every frame that moves
 * straight on, so an island whose carriers all move alike is solved in the frame in which they
 * stand still: it rests and costs as much as on a floor at rest. In any other frame thresholds
 * would be shares of the common velocity, and nothing would be found to rest.
 */
public final class CarriedFrame {

    private final Bodies bodies;
    private final Pairs pairs;
    private final Islands islands;
    private final Motions motions;

    public CarriedFrame(DataStorage data, Motions motions) {
        bodies = data.bodies;
        pairs = data.pairs;
        islands = data.islands;
        this.motions = motions;
    }

    /**
     * Puts an island's columns into the frame of its carriers, which coincides with the world's
     * frame when the step begins. Where carriers stand still, turn, or move differently, the
     * world's frame is used.
     */
    public void enter(int island) {
        find(island);
        if (motions.isInWorld()) {
            return;
        }
        driveCarriers(island, 0, 0);
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            int slot = islands.bodies[i];
            shift(slot, -bodies.pileTime[slot]);
            bodies.velocityX[slot] -= motions.frameX;
            bodies.velocityY[slot] -= motions.frameY;
        }
    }

    /** Puts them back, {@code dt} seconds after the step began. */
    public void leave(int island, double dt) {
        if (motions.isInWorld()) {
            return;
        }
        driveCarriers(island, motions.frameX, motions.frameY);
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            int slot = islands.bodies[i];
            shift(slot, dt);
            bodies.velocityX[slot] += motions.frameX;
            bodies.velocityY[slot] += motions.frameY;
        }
        motions.takeFrame(0, 0);
    }

    private void shift(int slot, double time) {
        if (time != 0) {
            bodies.x[slot] += time * motions.frameX;
            bodies.y[slot] += time * motions.frameY;
        }
    }

    private void find(int island) {
        int first = Pairs.NONE;
        for (int i = islands.pairStart[island]; i < islands.pairStart[island + 1]; i++) {
            int carrier = carrier(islands.pairs[i]);
            if (carrier != Pairs.NONE && carrier != first) {
                boolean isAlike = first == Pairs.NONE || moveAlike(first, carrier);
                if (!isAlike || !goesStraight(carrier)) {
                    return;
                }
                first = carrier;
            }
        }
        if (first != Pairs.NONE) {
            motions.takeFrame(bodies.velocityX[first], bodies.velocityY[first]);
        }
    }

    private void driveCarriers(int island, double x, double y) {
        for (int i = islands.pairStart[island]; i < islands.pairStart[island + 1]; i++) {
            int carrier = carrier(islands.pairs[i]);
            if (carrier != Pairs.NONE) {
                bodies.velocityX[carrier] = x;
                bodies.velocityY[carrier] = y;
            }
        }
    }

    private boolean moveAlike(int one, int other) {
        return bodies.velocityX[one] == bodies.velocityX[other]
                && bodies.velocityY[one] == bodies.velocityY[other];
    }

    private boolean goesStraight(int slot) {
        return bodies.isDriven(slot) && bodies.spinOf(slot) == 0;
    }

    /** That one of a pair that nobody moves, or none. */
    private int carrier(int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        return !bodies.isDynamic(a) ? a : !bodies.isDynamic(b) ? b : Pairs.NONE;
    }
}
