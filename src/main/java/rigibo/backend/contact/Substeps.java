package rigibo.backend.contact;

import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.Pairs;

/**
 * The number of substeps of a crowd. The error of a substep grows with the square of the distance
 * that bodies move in it, so that a creeping heap needs only one.
 */
final class Substeps {

    /**
     * Distance that a body moves in a step, in widths, from which on its crowd gets all substeps.
     */
    private static final double FAR = 0.4;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Islands islands;

    Substeps(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
        islands = data.islands;
    }

    /** Number of substeps of an island for a step of {@code dt} seconds, at most the usual one. */
    int of(int island, double dt, int usual) {
        return PackedContacts.areCrowd(islands, island) ? byWay(island, dt, usual) : usual;
    }

    /**
     * Number of substeps of an island, crowd or not, by the distance that its bodies move. It also
     * serves islands with joints of which only the equations are eliminated: these hold loads at
     * any length of substep, and their error grows with the square of the distance too.
     */
    int byWay(int island, double dt, int usual) {
        if (usual == 1 || isDriven(island)) {
            return usual;
        }
        double way = dt * fastest(island);
        return way >= FAR ? usual : (int) Math.max(1, Math.ceil(usual * way / FAR));
    }

    /** Whether a driven body or surface pushes the island. */
    private boolean isDriven(int island) {
        for (int i = islands.pairStart[island]; i < islands.pairStart[island + 1]; i++) {
            int pair = islands.pairs[i];
            if (drives(pairs.bodyA[pair]) || drives(pairs.bodyB[pair])) {
                return true;
            }
        }
        return false;
    }

    private boolean drives(int slot) {
        return bodies.isDriven(slot)
                && (bodies.velocityX[slot] != 0
                        || bodies.velocityY[slot] != 0
                        || bodies.spinOf(slot) != 0);
    }

    /** Highest speed of any point of a body, in its widths per second. */
    private double fastest(int island) {
        double most = 0;
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            int slot = islands.bodies[i];
            double straight = Math.abs(bodies.velocityX[slot]) + Math.abs(bodies.velocityY[slot]);
            double speed = bodies.turns() ? straight + turning(slot) : straight;
            most = Math.max(most, speed / bodies.smallestWidth[slot]);
        }
        return most;
    }

    /** Highest speed of a body's outline by its spin, m/s. */
    private double turning(int slot) {
        return Math.abs(bodies.spin[slot]) * bodies.sweepRadius[slot];
    }
}
