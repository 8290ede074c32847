package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;

/**
 * The equations of a crowd, solved group by group: the residuals of a group of joined bodies, and
 * the impulses that remove them.
 */
final class CrowdEquations {

    /** Most Newton steps towards impulses with which equations hold at the end of a drift. */
    private static final int MOST_STEPS = 3;

    /** Allowed error of a place, as a share of the joint's arms and of the tolerance. */
    private static final double MISSED_PLACE = 1e-2;

    /**
     * Allowed residual of an equation, as a share of the largest speed that an equation's impulse
     * gives in its group, and of the tolerance.
     */
    private static final double SETTLED = 1e-2;

    /** Residual above which a solution is refined, as a share of the allowed one. */
    private static final double SOLVED = 1e-4;

    /** Most refinements of a solution if bodies hardly moved before the kick. */
    private static final int REFINEMENTS = 2;

    /** Energy that Newton's steps may add, as a share of the kinetic energy. */
    private static final double GAINED = 1e-4;

    private final Motions motions;
    private final NeutralRows rows;
    private final JointPlaces jointPlaces;
    private final Poses poses;
    private final EquationFactor factor;
    private final EquationList equations;
    private final AssemblyTree tree;
    private final double tolerance;

    /** Velocities before places are held, laid out as the motions. */
    private double[] before = new double[64];

    /**
     * Allowed residual of an equation, as a share of the largest speed that an equation's impulse
     * gives in its group.
     */
    private final double settled;

    /** That share in this kick: smaller if bodies of a large group hardly moved before it. */
    private double left;

    CrowdEquations(
            Motions motions,
            NeutralRows rows,
            JointPlaces jointPlaces,
            Poses poses,
            EquationFactor factor,
            Accuracy accuracy) {
        this.motions = motions;
        this.rows = rows;
        this.jointPlaces = jointPlaces;
        this.poses = poses;
        this.factor = factor;
        equations = factor.equations();
        tree = factor.tree();
        tolerance = accuracy.impactTolerance();
        settled = SETTLED * tolerance;
    }

    /** Allowed error of a joint's place, as a share of its arms. */
    double missedPlace() {
        return MISSED_PLACE * tolerance;
    }

    /** Begins a kick in which residuals may be {@code finer} times the usual ones. */
    void begin(double finer) {
        left = finer * settled;
    }

    /** Whether the residual of a group is too large; {@link #settle} removes it. */
    boolean areOpen(int group) {
        return isBeyond(group, ask(group), left);
    }

    /**
     * Solves a group for the residuals of the last {@link #ask}; if {@code anew}, starting from
     * impulses of 0.
     */
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
     * Whether a speed in m/s exceeds a share of every speed that an equation's impulse gives its
     * own row in a group.
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

    /** Asks for the removal of a group's residuals; returns the largest, m/s. */
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
     * Holds the places of equations at the end of a drift of h seconds, in groups that no contact
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
            jointPlaces.measureAnew();
            isAny = false;
            for (int group = 0; group < tree.groups; group++) {
                if (!isPressed[group] && askPlaces(group, h) > 1) {
                    isAny = true;
                    pushAnswers(group);
                }
            }
        }
        if (motions.energy(motions.data) > (1 + GAINED) * energy) {
            // Only velocities are restored; impulses, which differ little, start the next kick.
            System.arraycopy(before, 0, motions.data, 0, length);
        }
    }

    /**
     * Asks for the changes of speed that close a group's places; returns the largest error, as a
     * multiple of the allowed one.
     */
    private double askPlaces(int group, double h) {
        double worst = 0;
        for (int i = tree.equationStart[group]; i < tree.equationStart[group + 1]; i++) {
            int e = tree.equationOf[i];
            int row = equations.row[e];
            if (row == EquationList.NONE) {
                factor.ask(e, 0);
            } else if (rows.isEquation(row) && rows.holdsPlace[row]) {
                double off = jointPlaces.of(row) - rows.place[row];
                factor.ask(e, -off / h);
                double most = missedPlace() * jointPlaces.size();
                worst = Math.max(worst, rows.inMetres(row, off) / most);
            } else {
                factor.ask(e, -rows.residual(row));
            }
        }
        return worst;
    }
}
