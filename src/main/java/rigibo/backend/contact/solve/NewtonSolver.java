package rigibo.backend.contact.solve;

import static rigibo.backend.contact.solve.FlatRows.KINDS;
import static rigibo.backend.contact.solve.FlatRows.ROLL;
import static rigibo.backend.contact.solve.FlatRows.TANGENT;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

/**
 * Solves a small island by Newton's method on Coulomb's law (P. Alart and A. Curnier, A mixed
 * formulation for frictional contact problems prone to Newton like solution methods, 1991). The
 * present impulse and speed of each row choose its equation: a point carries or is open, a contact
 * sticks or slides, and the friction of a sliding one is s·μ times the load being solved for; so
 * for its rolling. All equations are solved at once and chosen again until the choice no longer
 * changes. Near the solution that takes one or two systems; far from it the method may diverge,
 * which the passes between rounds detect.
 */
final class NewtonSolver {

    /** Most systems solved in one call; near the solution each doubles the number of digits. */
    private static final int MOST_STEPS = 8;

    /** Largest change of rows in a step, as a multiple of their impulses or residuals. */
    private static final double FARTHEST = 1e4;

    private final PackedContacts contacts;
    private final ContactOrder order;
    private final FlatRows rows;
    private final RowFactor factor;
    private final Halfway before;

    /** The rows that are equations. */
    private int[] set = new int[64];

    /** By row of the set: the change of its impulse to be solved for, N·s. */
    private double[] unknown = new double[64];

    private int size;

    /** Speed in m/s below which the load that causes it counts as none. */
    private double least;

    NewtonSolver(
            Motions motions,
            PackedContacts contacts,
            ContactOrder order,
            FlatRows rows,
            RowFactor factor) {
        before = new Halfway(motions, contacts);
        this.contacts = contacts;
        this.order = order;
        this.rows = rows;
        this.factor = factor;
    }

    /**
     * Solves the rows to a residual of {@code settled} m/s within a budget of multiplications.
     *
     * @return whether it succeeded; if not, bodies are as they were
     */
    boolean solve(int substep, double settled, double worth) {
        reserve();
        before.begin();
        least = settled;
        for (int step = 0; step < MOST_STEPS && factor.work() <= worth; step++) {
            choose(substep);
            if (rows.worst(set, size) <= settled) {
                return true;
            }
            factor.solveSet(set, size, unknown);
            if (isTooFar()) {
                before.takeBack();
                return false;
            }
            for (int i = 0; i < size; i++) {
                take(set[i], unknown[i]);
            }
        }
        return true;
    }

    /** Whether the rows contradict each other, so that only their compliance bounds the step. */
    private boolean isTooFar() {
        double strongest = 0;
        double farthest = 0;
        for (int i = 0; i < size; i++) {
            int k = set[i];
            double carried = rows.answer[k] * Math.abs(rows.impulse[k]);
            strongest = Math.max(strongest, Math.max(carried, Math.abs(rows.approach(k))));
            farthest = Math.max(farthest, rows.answer[k] * Math.abs(unknown[i]));
        }
        return !(farthest <= FARTHEST * strongest);
    }

    private void reserve() {
        if (set.length < KINDS * contacts.count) {
            set = new int[KINDS * contacts.pair.length];
            unknown = new double[KINDS * contacts.pair.length];
        }
    }

    private void choose(int substep) {
        size = 0;
        rows.followNone();
        for (int place = 0; place < contacts.count; place++) {
            if (contacts.firstSubstep[order.order[place]] <= substep) {
                choose(place, order.order[place]);
            }
        }
    }

    /** Chooses the equations of a contact; its other rows stay exactly at their bounds. */
    private void choose(int place, int row) {
        int normal = KINDS * place;
        int before = size;
        double load = 0;
        for (int k = normal; k < normal + contacts.points[row]; k++) {
            if (rows.answerAfterOwnChange(k) > least) {
                set[size++] = k;
                load += rows.impulse[k];
            } else {
                rows.set(k, 0);
            }
        }
        boolean isLoaded = size > before;
        chooseBounded(normal + TANGENT, isLoaded, load);
        chooseBounded(normal + ROLL, isLoaded, load);
    }

    /** Chooses whether a tangent or rolling row holds, or goes with the load that bounds it. */
    private void chooseBounded(int k, boolean isLoaded, double load) {
        double share = isLoaded ? rows.share(k) : 0;
        if (share == 0) {
            rows.set(k, 0);
        } else if (Math.abs(rows.wanted(k)) < share * load) {
            set[size++] = k;
        } else {
            double follows = Math.copySign(share, rows.wanted(k));
            rows.follow(k, follows);
            rows.set(k, follows * load);
        }
    }

    /** Applies a change up to where a point would pull, with what goes with its load. */
    private void take(int k, double change) {
        if (FlatRows.isPoint(k)) {
            rows.pushWithFollowing(k, Math.max(change, -rows.impulse[k]));
        } else {
            rows.push(k, change);
        }
    }
}
