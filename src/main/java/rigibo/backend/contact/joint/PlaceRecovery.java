package rigibo.backend.contact.joint;

import static rigibo.backend.contact.row.Motions.DX;
import static rigibo.backend.contact.row.Motions.DY;
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

    /** What rows give way by where they ask for too much, as a share of their responses. */
    private static final double LEAST_GIVE = 1e-6;

    private static final double MORE_GIVE = 100;

    private final Bodies bodies;
    private final Motions motions;
    private final NeutralRows rows;
    private final JointRows jointRows;
    private final Poses poses;
    private final RowElimination elimination;
    private final Displacement moved;
    private final double tolerance;

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
            move(Recovery.MOST_PUSH * Math.abs(h));
        }
    }

    /** Asks a row to move back by what it is off; whether that is more than it may miss. */
    private boolean ask(int row, double h) {
        double place = jointRows.place(row);
        double off = rows.isEquation(row) ? place : Math.min(0, place);
        double size = jointRows.size() / rows.unit[row];
        double most = Math.max(SMALL, Recovery.MOST_PUSH * Math.abs(h)) * size;
        wanted[row] = -Math.max(-most, Math.min(most, off));
        double missed = JointSolver.MISSED * tolerance * size;
        return Math.abs(off) > missed + 2 * jointRows.roundOff() / rows.unit[row];
    }

    private void leaveContactsOut() {
        for (int row = 0; row < rows.count; row++) {
            if (rows.joint[row] == NeutralRows.NONE) {
                elimination.put(row, false);
            }
        }
    }

    /**
     * Moves outlines by what is wanted, so that none goes farther than that. Where one would, rows
     * give way more and more: what hardly any movement answers is then left for later, and all else
     * is closed (damped least squares, K. Levenberg 1944). A share of all would leave all open.
     */
    private void move(double most) {
        moved.begin();
        double farthest = moveAll();
        for (double give = LEAST_GIVE; farthest > most && give < 1; give *= MORE_GIVE) {
            moved.scaleAll(0);
            elimination.regularize(give);
            farthest = moveAll();
        }
        elimination.regularize(NeutralRows.REGULAR);
        if (farthest > most) {
            moved.scaleAll(most / farthest);
        }
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
