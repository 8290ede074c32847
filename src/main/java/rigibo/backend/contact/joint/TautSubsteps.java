package rigibo.backend.contact.joint;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.JointStore;

/**
 * How many substeps what is taut needs. A load F at an arm r of a body of inertia I turns it back
 * by F·r for each radian, so that it trembles at ω² = ΣF·r/I: a light link between a hook and a
 * heavy weight a thousand times a second. Kicks along the rows of a substep's start follow that as
 * long as ω·h is below 2.
 */
final class TautSubsteps {

    /** rad of the trembling in a substep. */
    static final double MOST_PHASE = 0.8;

    /** Times as many substeps as usual, at most. */
    private static final int MOST_MORE = 32;

    /**
     * How many times more substeps an island is given in which something touches: what is struck
     * carries an impact, not a load that lasts. A taut bridge that something rolls over gaped by
     * decimetres in one substep of 2.2 rad.
     */
    private static final int MOST_MORE_IF_TOUCHED = 4;

    /**
     * Times as many substeps as usual that are worth following at the accuracy of a game where
     * something touches, where no load explains the tension, as of a straight bridge, and in
     * islands of many bodies. What would take more may just as well be still.
     */
    private static final int MOST_FOLLOWED = 2;

    /**
     * Times that the loads of all bodies together may pull at a joint where they explain it: a bob
     * that goes full circle pulls by six times its weight.
     */
    private static final double MOST_LOADS = 8;

    /** Bodies of the largest island that is given more: one wild joint of a crowd costs all. */
    private static final int MOST_BODIES = 64;

    private final Bodies bodies;
    private final JointStore joints;
    private final Islands islands;

    /** By slot: the square of what it trembles at, 1/s². */
    private double[] square = new double[16];

    TautSubsteps(DataStorage data) {
        bodies = data.bodies;
        joints = data.jointsOrNone();
        islands = data.islands;
    }

    /** Substeps for an island in a step of dt seconds, by what its joints carried in the last. */
    int count(int island, double dt, int usual) {
        if (areMany(island)) {
            return usual;
        }
        int most = meetsOthers(island) ? MOST_MORE_IF_TOUCHED : MOST_MORE;
        return (int) Math.ceil(Math.max(usual, Math.min(most * usual, wanted(island, dt))));
    }

    /** Whether an island trembles faster than is worth following. */
    boolean isBeyond(int island, double dt, int usual) {
        double wanted = wanted(island, dt);
        if (wanted <= MOST_FOLLOWED * usual) {
            return false;
        }
        boolean isFollowed = !areMany(island) && !meetsOthers(island) && !isWedged(island);
        return !isFollowed || wanted > MOST_MORE * usual;
    }

    /**
     * Whether an island is tauter than its loads explain: what pulls at its bodies, and what keeps
     * them on their way round, which turns no sharper than by their own width. Then it is as long
     * as its span, and whatever it does is what its joints are off by.
     */
    boolean isWedged(int island) {
        double strongest = 0;
        for (int i = islands.jointStart[island]; i < islands.jointStart[island + 1]; i++) {
            int joint = islands.joints[i];
            if (joints.stiffness[joint] > 0 || joints.motorMost[joint] > 0) {
                return false;
            }
            double force = length(joints.reactionX[joint], joints.reactionY[joint]);
            strongest = Math.max(strongest, force);
        }
        double loads = 0;
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            loads += load(islands.bodies[i]);
        }
        return strongest > MOST_LOADS * loads;
    }

    /** The most that pulls at a body or bends its way, N. */
    private double load(int slot) {
        if (!(bodies.inverseMass[slot] > 0)) {
            return 0;
        }
        double x = bodies.velocityX[slot];
        double y = bodies.velocityY[slot];
        double pull = length(bodies.accelerationX[slot], bodies.accelerationY[slot]);
        return (pull + (x * x + y * y) / bodies.smallestWidth[slot]) / bodies.inverseMass[slot];
    }

    /** Substeps that follow what trembles. */
    private double wanted(int island, double dt) {
        return Math.sqrt(square(island)) * dt / MOST_PHASE;
    }

    private boolean areMany(int island) {
        return islands.bodyStart[island + 1] - islands.bodyStart[island] > MOST_BODIES;
    }

    private boolean meetsOthers(int island) {
        return islands.pairStart[island + 1] > islands.pairStart[island];
    }

    /**
     * The square of the fastest trembling by what an island's joints carried last, 1/s²; 0 where
     * nothing turns.
     */
    double square(int island) {
        if (!bodies.turns()) {
            return 0;
        }
        if (square.length < bodies.type.length) {
            square = new double[bodies.type.length];
        }
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            square[islands.bodies[i]] = 0;
        }
        double most = 0;
        for (int i = islands.jointStart[island]; i < islands.jointStart[island + 1]; i++) {
            most = Math.max(most, add(islands.joints[i]));
        }
        return most;
    }

    private double add(int joint) {
        double x = joints.reactionX[joint];
        double y = joints.reactionY[joint];
        double force = Math.sqrt(x * x + y * y);
        int a = joints.bodyA[joint];
        int b = joints.bodyB[joint];
        double armA = length(joints.anchorAX[joint], joints.anchorAY[joint]);
        double armB = length(joints.anchorBX[joint], joints.anchorBY[joint]);
        double onA = bodies.isDynamic(a) ? force * armA * bodies.inverseInertia[a] : 0;
        double onB = bodies.isDynamic(b) ? force * armB * bodies.inverseInertia[b] : 0;
        if (bodies.isDynamic(a)) {
            square[a] += onA;
            onA = square[a];
        }
        if (bodies.isDynamic(b)) {
            square[b] += onB;
            onB = square[b];
        }
        return Math.max(onA, onB);
    }

    private static double length(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }
}
