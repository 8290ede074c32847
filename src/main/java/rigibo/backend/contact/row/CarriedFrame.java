package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.Pairs;

/**
 * The frame of the bodies that carry an island, by contacts or joints. The laws are the same in all
 * inertial frames, so an island whose carriers all have the same constant velocity is solved in the
 * frame in which they stand still. It then comes to rest, and costs as much, as on a floor at rest.
 * In any other frame thresholds would be shares of the common velocity, and no island would rest.
 */
public final class CarriedFrame {

    private final Bodies bodies;
    private final Pairs pairs;
    private final Islands islands;
    private final Motions motions;
    private final JointStore joints;

    /** The carriers of the island; some are listed more than once. */
    private final Found carriers = new Found();

    public CarriedFrame(DataStorage data, Motions motions) {
        joints = data.joints;
        bodies = data.bodies;
        pairs = data.pairs;
        islands = data.islands;
        this.motions = motions;
    }

    /**
     * Transforms an island's columns into the frame of its carriers, which coincides with the world
     * frame when the step begins. If carriers stand still, turn or move differently, or a joint
     * holds a body at a world point, the world frame is kept.
     */
    public void enter(int island) {
        find(island);
        if (motions.isInWorld()) {
            return;
        }
        driveCarriers(0, 0);
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            int slot = islands.bodies[i];
            shift(slot, -bodies.pileTime[slot]);
            bodies.velocityX[slot] -= motions.frameX;
            bodies.velocityY[slot] -= motions.frameY;
        }
    }

    /** Transforms the columns back, {@code dt} seconds after the step began. */
    public void leave(int island, double dt) {
        if (motions.isInWorld()) {
            return;
        }
        driveCarriers(motions.frameX, motions.frameY);
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
        carriers.clear();
        boolean mayMove = true;
        for (int i = islands.pairStart[island]; mayMove && i < islands.pairStart[island + 1]; i++) {
            int pair = islands.pairs[i];
            mayMove = add(pairs.bodyA[pair]) && add(pairs.bodyB[pair]);
        }
        if (mayMove && islands.areJoined(island)) {
            mayMove = addJoined(island);
        }
        if (mayMove && carriers.count > 0 && mayFollow(island, carriers.numbers[0])) {
            int first = carriers.numbers[0];
            motions.takeFrame(bodies.velocityX[first], bodies.velocityY[first]);
        }
    }

    /** Whether no locked axis keeps a body of the island from moving along with a carrier. */
    private boolean mayFollow(int island, int carrier) {
        boolean mayFollow = true;
        int end = bodies.lockedX == null ? 0 : islands.bodyStart[island + 1];
        for (int i = islands.bodyStart[island]; mayFollow && i < end; i++) {
            int slot = islands.bodies[i];
            mayFollow =
                    !(bodies.lockedX[slot] && bodies.velocityX[carrier] != 0)
                            && !(bodies.lockedY[slot] && bodies.velocityY[carrier] != 0);
        }
        return mayFollow;
    }

    /**
     * Adds the carriers at the other end of joints; returns false if a joint holds a world point.
     */
    private boolean addJoined(int island) {
        boolean mayMove = true;
        for (int i = islands.jointStart[island];
                mayMove && i < islands.jointStart[island + 1];
                i++) {
            int joint = islands.joints[i];
            mayMove = !joints.holdsOnToPlace(joint) && addEnds(joint);
            if (mayMove && joints.firstGeared[joint] != JointStore.NONE) {
                mayMove = addEnds(joints.firstGeared[joint]) && addEnds(joints.secondGeared[joint]);
            }
        }
        return mayMove;
    }

    private boolean addEnds(int joint) {
        return add(joints.bodyA[joint]) && add(joints.bodyB[joint]);
    }

    /** Adds a carrier; returns whether it translates with the same velocity as those before it. */
    private boolean add(int slot) {
        if (bodies.isDynamic(slot)) {
            return true;
        }
        int last = carriers.count - 1;
        if (last >= 0 && carriers.numbers[last] == slot) {
            return true;
        }
        boolean isAlike = last < 0 || moveAlike(carriers.numbers[last], slot);
        carriers.add(slot);
        return isAlike && goesStraight(slot);
    }

    private void driveCarriers(double x, double y) {
        for (int i = 0; i < carriers.count; i++) {
            bodies.velocityX[carriers.numbers[i]] = x;
            bodies.velocityY[carriers.numbers[i]] = y;
        }
    }

    private boolean moveAlike(int one, int other) {
        return bodies.velocityX[one] == bodies.velocityX[other]
                && bodies.velocityY[one] == bodies.velocityY[other];
    }

    private boolean goesStraight(int slot) {
        return bodies.isDriven(slot) && bodies.spinOf(slot) == 0;
    }
}
