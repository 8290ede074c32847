package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;

/**
 * The equations of a crowd, group by group: what bodies of a group lack that joints hold together,
 * and the impulses that give it to them.
 */
final class CrowdEquations {

    /** Newton's steps to where equations hold at the end of a drift. */
    private static final int MOST_STEPS = 3;

    /** How far a place may be missed, as a share of the joint's arms and of the tolerance. */
    private static final double MISSED_PLACE = 1e-2;

    /** What an equation may lack, as a share of the strongest of its group and of the tolerance. */
    private static final double SETTLED = 1e-2;

    /** What a solution may lack before it is refined, as a share of that. */
    private static final double SOLVED = 1e-4;

    /** Solutions that take back what the first one left, where bodies hardly move. */
    private static final int REFINEMENTS = 2;

    /** Energy that Newton's steps may add, as a share of that of motion. */
    private static final double GAINED = 1e-4;

    private final Motions motions;
    private final NeutralRows rows;
    private final JointRows jointRows;
    private final Poses poses;
    private final EquationFactor factor;
    private final EquationList equations;
    private final AssemblyTree tree;
    private final double tolerance;

    /** Velocities before places are held, as the motions. */
    private double[] before = new double[64];

    /** What an equation may lack, as a share of the strongest of its group. */
    private final double settled;

    /** What it may lack in this kick; less if bodies of a large group hardly moved before it. */
    private double left;

    CrowdEquations(
            Motions motions,
            NeutralRows rows,
            JointRows jointRows,
            Poses poses,
            EquationFactor factor,
            Accuracy accuracy) {
        this.motions = motions;
        this.rows = rows;
        this.jointRows = jointRows;
        this.poses = poses;
        this.factor = factor;
        equations = factor.equations();
        tree = factor.tree();
        tolerance = accuracy.impactTolerance();
        settled = SETTLED * tolerance;
    }

    /** How far the place of a joint may be missed, as a share of its arms. */
    double missedPlace() {
        return MISSED_PLACE * tolerance;
    }

    /** Begins a kick in which equations may lack a share of the usual. */
    void begin(double finer) {
        left = finer * settled;
    }

    /** Whether a group lacks more than counts; {@link #settle} gives it what it lacks. */
    boolean areOpen(int group) {
        return isBeyond(group, ask(group), left);
    }

    /** Gives a group what it was asked for last, or finds all of its impulses anew. */
    void settle(int group, boolean anew) {
        if (anew) {
            takeBack(group);
            ask(group);
        }
        pushAnswers(group);
        int refinements = left < settled ? REFINEMENTS : 1;
        for (int i = 0; i < refinements && isBeyond(group, ask(group), SOLVED * left); i++) {
            pushAnswers(group);
        }
    }

    /**
     * Whether a speed (m/s) is beyond a share of all speeds that impulses of a group's equations
     * give their rows.
     */
    private boolean isBeyond(int group, double speed, double share) {
        boolean isBeyond = speed > 0;
        int end = tree.equationStart[group + 1];
        for (int i = tree.equationStart[group]; isBeyond && i < end; i++) {
            int row = equations.row[tree.equationOf[i]];
            isBeyond = row == EquationList.NONE || speed > share * rows.ownSpeed(row);
        }
        return isBeyond;
    }

    private void takeBack(int group) {
        for (int i = tree.equationStart[group]; i < tree.equationStart[group + 1]; i++) {
            int row = equations.row[tree.equationOf[i]];
            if (row != EquationList.NONE) {
                rows.push(row, -rows.impulse[row]);
                rows.impulse[row] = 0;
            }
        }
    }

    /** Asks what holds in a group for what it lacks; the most, m/s. */
    double ask(int group) {
        double most = 0;
        for (int i = tree.equationStart[group]; i < tree.equationStart[group + 1]; i++) {
            int e = tree.equationOf[i];
            int row = equations.row[e];
            double lacks = row == EquationList.NONE ? 0 : -rows.residual(row);
            factor.ask(e, lacks);
            most = row == EquationList.NONE ? most : Math.max(most, rows.inMetres(row, lacks));
        }
        return most;
    }

    private void pushAnswers(int group) {
        factor.solve(group);
        for (int i = tree.equationStart[group]; i < tree.equationStart[group + 1]; i++) {
            int e = tree.equationOf[i];
            if (equations.row[e] != EquationList.NONE) {
                rows.push(equations.row[e], factor.answer(e));
            }
        }
    }

    /**
     * Holds the places of equations at the end of a drift of h seconds, in groups on which nothing
     * presses.
     */
    void holdPlaces(double h, boolean[] isPressed) {
        double energy = motions.energy(motions.data);
        int length = motions.count * Motions.STRIDE;
        if (before.length < length) {
            before = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, before, 0, length);
        boolean isAny = true;
        for (int i = 0; i < MOST_STEPS && isAny; i++) {
            poses.take(h);
            jointRows.measureAnew();
            isAny = false;
            for (int group = 0; group < tree.groups; group++) {
                if (!isPressed[group] && askPlaces(group, h) > 1) {
                    isAny = true;
                    pushAnswers(group);
                }
            }
        }
        if (motions.energy(motions.data) > (1 + GAINED) * energy) {
            // Impulses are those of before but for what changes no body.
            System.arraycopy(before, 0, motions.data, 0, length);
        }
    }

    /** Asks a group for what places would be missed by; the most, as a multiple of what may be. */
    private double askPlaces(int group, double h) {
        double worst = 0;
        for (int i = tree.equationStart[group]; i < tree.equationStart[group + 1]; i++) {
            int e = tree.equationOf[i];
            int row = equations.row[e];
            if (row == EquationList.NONE) {
                factor.ask(e, 0);
            } else if (rows.isEquation(row) && rows.holdsPlace[row]) {
                double off = jointRows.place(row) - rows.place[row];
                factor.ask(e, -off / h);
                double most = missedPlace() * jointRows.size();
                worst = Math.max(worst, rows.inMetres(row, off) / most);
            } else {
                factor.ask(e, -rows.residual(row));
            }
        }
        return worst;
    }
}
