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
 * Removes the position errors of joints by moving bodies, in an island that is eliminated as a
 * whole. The joints of a straight bridge constrain nearly everything along it and nearly nothing
 * across, so that closing them exactly could throw bodies about, or lift them without a force.
 */
final class PlaceRecovery {

    /** Error that is removed at once, m per metre of the joint's arms. */
    private static final double SMALL = 1e-4;

    /**
     * Displacement that is always allowed, as a multiple of the largest error of an equation.
     * Hinges of a straight bridge ask for far more; the straighter it is, the harder they are to
     * close.
     */
    private static final double FEW = 4;

    /**
     * Compliances of rows that ask for too large displacements, as shares of their responses: the
     * first, the factor to the next, and the last.
     */
    static final double LEAST_GIVE = 1e-6;

    static final double MORE_GIVE = 100;
    static final double MOST_GIVE = 1e-2;

    private final Bodies bodies;
    private final Motions motions;
    private final NeutralRows rows;
    private final JointPlaces jointPlaces;
    private final Poses poses;
    private final RowElimination elimination;
    private final Displacement moved;
    private final double tolerance;

    /** By row: the displacement that is asked for, m or rad. */
    private double[] wanted = new double[64];

    /**
     * By row with bounds: the displacement that is asked for, while equations are closed alone, m
     * or rad.
     */
    private double[] ofLimit = new double[64];

    PlaceRecovery(
            Bodies bodies,
            Motions motions,
            NeutralRows rows,
            JointPlaces jointPlaces,
            Poses poses,
            RowElimination elimination,
            double tolerance) {
        this.bodies = bodies;
        this.motions = motions;
        this.rows = rows;
        this.jointPlaces = jointPlaces;
        this.poses = poses;
        this.elimination = elimination;
        moved = new Displacement(motions);
        this.tolerance = tolerance;
    }

    /** Moves bodies after a drift of h seconds. */
    void correct(double h) {
        double most = mostWay(h);
        if (asks(h) && !closesOnContacts(most)) {
            closeWithoutContacts(most);
        }
    }

    private void closeWithoutContacts(double most) {
        double farthest = close(most);
        boolean isNear = farthest <= most;
        if (!isNear && !closesEquations(most, farthest)) {
            giveWayMoreAndMore(most);
        }
    }

    /** Largest displacement of an outline in a drift of h seconds, as a share of its reach. */
    private static double mostWay(double h) {
        return Recovery.MOST_PUSH * Math.abs(h);
    }

    /** Asks for all held places to be closed; returns whether any error is larger than allowed. */
    private boolean asks(double h) {
        poses.take(0);
        jointPlaces.measureAnew();
        if (wanted.length < rows.count) {
            wanted = new double[rows.bodies.length];
            ofLimit = new double[rows.bodies.length];
        }
        boolean isAny = false;
        for (int row = 0; row < rows.count; row++) {
            wanted[row] = 0;
            if (rows.holdsPlace[row] && elimination.isIn(row)) {
                isAny |= ask(row, h);
            }
        }
        if (isAny) {
            leaveContactsOut();
        }
        return isAny;
    }

    /**
     * Closes all places without pushing bodies into what they lie on: loaded contacts keep their
     * gaps, except for those that would have to pull. Returns false if no contact carries load, or
     * if an outline would move too far, since contacts may contradict joints.
     */
    private boolean closesOnContacts(double most) {
        boolean isAny = false;
        for (int row = 0; row < rows.count; row++) {
            if (rows.isPoint(row) && rows.impulse[row] > 0) {
                elimination.put(row, true);
                isAny = true;
            }
        }
        boolean isClosed = isAny && closeWithoutPulling() && close(most) <= most;
        if (isAny && !isClosed) {
            leaveContactsOut();
        }
        return isClosed;
    }

    /** Removes contacts from the set that would have to pull; returns whether any is left. */
    private boolean closeWithoutPulling() {
        boolean isAnyLeft = true;
        boolean isAnyPulled = true;
        while (isAnyPulled) {
            elimination.solveFor(wanted);
            isAnyPulled = false;
            isAnyLeft = false;
            int size = elimination.size();
            for (int i = 0; i < size; i++) {
                int row = elimination.row(i);
                boolean isContact = rows.isPoint(row);
                if (isContact && elimination.answer(i) < 0) {
                    elimination.put(row, false);
                    isAnyPulled = true;
                } else {
                    isAnyLeft |= isContact;
                }
            }
        }
        return isAnyLeft;
    }

    /** Asks for a row's error to be removed; returns whether it is larger than allowed. */
    private boolean ask(int row, double h) {
        double place = jointPlaces.of(row);
        double off = rows.isEquation(row) ? place : Math.min(0, place);
        double size = jointPlaces.size() / rows.unit[row];
        double most = Math.max(SMALL, Recovery.MOST_PUSH * Math.abs(h)) * size;
        wanted[row] = -Math.max(-most, Math.min(most, off));
        double missed = JointPlaces.MISSED * tolerance * size;
        return Math.abs(off) > missed + 2 * jointPlaces.roundOff() / rows.unit[row];
    }

    /** Removes contacts from the set; overlap that results is removed separately. */
    private void leaveContactsOut() {
        for (int row = 0; row < rows.count; row++) {
            if (rows.joint[row] == NeutralRows.NONE) {
                elimination.put(row, false);
            }
        }
    }

    /**
     * Moves outlines as asked, unless one would move too far; returns the largest displacement that
     * was asked for, as a share of the outline's reach.
     */
    private double close(double most) {
        moved.begin();
        double farthest = moveAll();
        boolean isNear = farthest <= most;
        if (!isNear) {
            moved.scaleAll(0);
        }
        return farthest;
    }

    /**
     * Closes all equations, and limits as far as outlines may move. Returns false if equations
     * alone ask for too large displacements: they then nearly contradict each other.
     *
     * @param ofAll the largest displacement with all places closed, as a share of the outline's
     *     reach
     */
    private boolean closesEquations(double most, double ofAll) {
        double asked = 0;
        for (int row = 0; row < rows.count; row++) {
            if (!rows.isEquation(row)) {
                ofLimit[row] = wanted[row];
                wanted[row] = 0;
            }
            asked = Math.max(asked, rows.inMetres(row, Math.abs(wanted[row])));
        }
        moved.begin();
        double alone = moveAll();
        if (alone > most && farthestInMetres() > FEW * asked) {
            moved.scaleAll(0);
            restoreLimits(1);
            return false;
        }
        double share = (most - alone) / (ofAll + alone);
        if (share > 0) {
            moved.scaleAll(0);
            restoreLimits(share);
            moveAll();
        }
        return true;
    }

    private void restoreLimits(double share) {
        for (int row = 0; row < rows.count; row++) {
            if (!rows.isEquation(row)) {
                wanted[row] = share * ofLimit[row];
            }
        }
    }

    /**
     * Moves outlines with the smallest compliance of rows at which none moves too far (damped least
     * squares, K. Levenberg 1944). Errors that hardly any movement removes are then left for later,
     * and all others are closed, while scaling everything down would leave all of them open.
     */
    private void giveWayMoreAndMore(double most) {
        double give = LEAST_GIVE;
        while (!giveWay(give, most) && give < MOST_GIVE) {
            moved.scaleAll(0);
            give *= MORE_GIVE;
        }
    }

    /**
     * Moves outlines with a compliance of rows, as a share of their responses; returns whether none
     * moves too far.
     */
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

    /** Moves outlines as asked; returns the largest displacement, as a share of the reach. */
    private double moveAll() {
        elimination.solveFor(wanted);
        for (int i = 0; i < elimination.size(); i++) {
            rows.move(elimination.row(i), elimination.answer(i), DX);
        }
        return farthest();
    }

    /** The largest displacement of an outline, as a share of its reach. */
    private double farthest() {
        double most = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            most = Math.max(most, way(entry) / bodies.boundingRadius[motions.slots[entry]]);
        }
        return most;
    }

    /** The largest displacement of an outline, m. */
    private double farthestInMetres() {
        double most = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            most = Math.max(most, way(entry));
        }
        return most;
    }

    private double way(int entry) {
        int at = entry * STRIDE;
        double turned = Math.abs(moved.of(at + TURN));
        double turning = turned == 0 ? 0 : motions.reach[entry] * turned;
        return Math.abs(moved.of(at + DX)) + Math.abs(moved.of(at + DY)) + turning;
    }
}
