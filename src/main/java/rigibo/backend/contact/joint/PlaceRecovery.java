package rigibo.backend.contact.joint;

import static rigibo.backend.contact.row.Motions.DX;
import static rigibo.backend.contact.row.Motions.DY;
import static rigibo.backend.contact.row.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.STRIDE;
import static rigibo.backend.contact.row.Motions.TURN;

import rigibo.backend.contact.row.Displacement;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.storage.Bodies;

/**
 * Takes back what joints are off their places by moving bodies, in an island that is eliminated
 * whole. Joints that hold a straight bridge hold nearly everything along it and nearly nothing
 * across: what closes them there may throw bodies about, and lift them by no force.
 */
final class PlaceRecovery {

    /** Error that is taken back at once, m per metre of the joint's arms. */
    private static final double SMALL = 1e-4;

    /**
     * Error that stays where an island is too taut, as a share of the tolerance, m per metre of the
     * joint's arms: what takes it back lifts a bridge that has sagged by it, by no force.
     */
    private static final double KEPT = 0.1;

    /** What rows give way by where they ask for too much, as shares of their responses. */
    private static final double LEAST_GIVE = 1e-6;

    private static final double MORE_GIVE = 100;
    private static final double MOST_GIVE = 1e-2;

    private final Bodies bodies;
    private final Motions motions;
    private final NeutralRows rows;
    private final JointRows jointRows;
    private final Poses poses;
    private final RowElimination elimination;
    private final Displacement moved;
    private final double tolerance;

    /** Error that stays in the island that is corrected, m per metre of the joint's arms. */
    private double kept;

    /** By row: how far it is to be moved, m or rad. */
    private double[] wanted = new double[64];

    PlaceRecovery(
            Bodies bodies,
            Motions motions,
            NeutralRows rows,
            JointRows jointRows,
            Poses poses,
            RowElimination elimination,
            double tolerance) {
        this.bodies = bodies;
        this.motions = motions;
        this.rows = rows;
        this.jointRows = jointRows;
        this.poses = poses;
        this.elimination = elimination;
        moved = new Displacement(motions);
        this.tolerance = tolerance;
    }

    /** Moves bodies after a drift of h seconds. */
    void correct(double h) {
        double most = mostWay(h);
        kept = 0;
        if (asks(h) && !closes(most)) {
            giveWayMoreAndMore(most);
        }
    }

    /** Moves the bodies of an island that is too taut for its joints to be closed at once. */
    void correctTaut(double h) {
        kept = KEPT * tolerance;
        if (asks(h)) {
            double most = mostWay(h);
            giveWay(Math.max(NeutralRows.REGULAR, give(most)), most);
        }
    }

    /** How far an outline may be moved in a drift of h seconds, as a share of what it reaches. */
    private static double mostWay(double h) {
        return Recovery.MOST_PUSH * Math.abs(h);
    }

    /** Asks all places that are held to be closed; whether one is off by more than it may be. */
    private boolean asks(double h) {
        poses.take(0);
        jointRows.measureAnew();
        if (wanted.length < rows.count) {
            wanted = new double[rows.bodies.length];
        }
        boolean isAny = false;
        for (int row = 0; row < rows.count; row++) {
            wanted[row] = 0;
            if (rows.holdsPlace[row] && elimination.isIn(row)) {
                isAny |= ask(row, h);
            }
        }
        if (isAny) {
            // Contacts might contradict: what is moved into them is taken back by itself.
            leaveContactsOut();
        }
        return isAny;
    }

    /** Asks a row to move back by what it is off; whether that is more than it may miss. */
    private boolean ask(int row, double h) {
        double place = jointRows.place(row);
        double off = rows.isEquation(row) ? place : Math.min(0, place);
        double size = jointRows.size() / rows.unit[row];
        double over = Math.copySign(Math.max(0, Math.abs(off) - kept * size), off);
        double most = Math.max(SMALL, Recovery.MOST_PUSH * Math.abs(h)) * size;
        wanted[row] = -Math.max(-most, Math.min(most, over));
        double missed = JointSolver.MISSED * tolerance * size;
        return Math.abs(over) > missed + 2 * jointRows.roundOff() / rows.unit[row];
    }

    private void leaveContactsOut() {
        for (int row = 0; row < rows.count; row++) {
            if (rows.joint[row] == NeutralRows.NONE) {
                elimination.put(row, false);
            }
        }
    }

    /** Moves outlines by what is wanted, unless one would go farther than that; whether it did. */
    private boolean closes(double most) {
        moved.begin();
        boolean isNear = moveAll() <= most;
        if (!isNear) {
            moved.scaleAll(0);
        }
        return isNear;
    }

    /**
     * Moves outlines by what is wanted with rows that give way as little as they must, so that none
     * goes farther than that: what hardly any movement answers is then left for later, and all else
     * is closed (damped least squares, K. Levenberg 1944). A share of all would leave all open.
     */
    private void giveWayMoreAndMore(double most) {
        double give = LEAST_GIVE;
        while (!giveWay(give, most) && give < MOST_GIVE) {
            moved.scaleAll(0);
            give *= MORE_GIVE;
        }
    }

    /** Moves outlines with rows that give way by a share; whether none would go farther. */
    private boolean giveWay(double share, double most) {
        moved.begin();
        elimination.regularize(share);
        double farthest = moveAll();
        elimination.regularize(NeutralRows.REGULAR);
        if (farthest > most) {
            moved.scaleAll(most / farthest);
        }
        return farthest <= most;
    }

    /**
     * What rows are to give way by, as a share g of their responses D, so that no outline goes
     * farther than that. By x = (K + g·D)⁻¹·b bodies are moved by M⁻¹·Jᵀ·x, and Σ m·s² of all moves
     * is xᵀ·K·x, no more than bᵀ·D⁻¹·b/4g whatever K is: σ/(σ + g)² is greatest at σ = g. An
     * outline of mass m, inertia I and reach r goes no farther than √(2/m + r²/I) times the root of
     * that.
     */
    private double give(double most) {
        double asked = 0;
        double lightest = 0;
        for (int row = 0; row < rows.count; row++) {
            if (elimination.isIn(row)) {
                asked += wanted[row] * wanted[row] / rows.response[row];
                lightest = Math.max(lightest, lightest(row));
            }
        }
        return Math.min(MOST_GIVE, asked * lightest / (4 * most * most));
    }

    /** The greatest 2/m + r²/I of a row's bodies by the square of what one reaches, 1/(kg·m²). */
    private double lightest(int row) {
        double most = 0;
        for (int k = 0; k < rows.bodies[row]; k++) {
            int at = rows.body[row * NeutralRows.BODIES + k];
            int entry = at / STRIDE;
            double reach = motions.reach[entry];
            double inertia = motions.data[at + INVERSE_INERTIA];
            double turning = inertia == 0 ? 0 : reach * reach * inertia;
            double radius = bodies.boundingRadius[motions.slots[entry]];
            double moving = 2 * motions.data[at + INVERSE_MASS];
            most = Math.max(most, (moving + turning) / (radius * radius));
        }
        return most;
    }

    /** Moves outlines by what is wanted; the farthest of them, as a share of what it reaches. */
    private double moveAll() {
        elimination.solveFor(wanted);
        for (int i = 0; i < elimination.size(); i++) {
            rows.move(elimination.row(i), elimination.answer(i), DX);
        }
        return farthest();
    }

    /** The farthest that an outline was moved, as a share of what it reaches. */
    private double farthest() {
        double farthest = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            int at = entry * STRIDE;
            double turned = Math.abs(moved.of(at + TURN));
            double turning = turned == 0 ? 0 : motions.reach[entry] * turned;
            double way = Math.abs(moved.of(at + DX)) + Math.abs(moved.of(at + DY)) + turning;
            farthest = Math.max(farthest, way / bodies.boundingRadius[motions.slots[entry]]);
        }
        return farthest;
    }
}
