package rigibo.backend.contact;

import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.Pairs;

/**
 * How many substeps a crowd is given. Substeps keep small what is neglected along the way of a
 * body, and that grows with the square of the way: a heap that creeps needs but one.
 */
final class Substeps {

    /** Way of a body in a step, in its widths, from which on its crowd gets all substeps. */
    private static final double FAR = 0.4;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Islands islands;

    Substeps(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
        islands = data.islands;
    }

    /** Substeps of an island for a step of {@code dt} seconds, of the usual number at most. */
    int of(int island, double dt, int usual) {
        return PackedContacts.areCrowd(islands, island) ? byWay(island, dt, usual) : usual;
    }

    /**
     * Substeps of an island, crowd or not, by the way that its bodies go. Of an island with joints
     * whose equations alone are eliminated, what it carries is held at any length of substep, and
     * what it neglects grows with the square of the way.
     */
    int byWay(int island, double dt, int usual) {
        if (usual == 1 || isDriven(island)) {
            return usual;
        }
        double way = dt * fastest(island);
        return way >= FAR ? usual : (int) Math.max(1, Math.ceil(usual * way / FAR));
    }

    /** Whether something pushes the island at a speed of its own. */
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

    /** The highest speed of any point of a body, in its widths a second. */
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

    /** Speed that turning gives the outline of a body, m/s. */
    private double turning(int slot) {
        return Math.abs(bodies.spin[slot]) * bodies.sweepRadius[slot];
    }
}
