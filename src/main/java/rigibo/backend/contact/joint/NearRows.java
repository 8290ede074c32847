package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Effort;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;

/**
 * Keeps impulses of rows near those of the last kick, by a compliance towards their change: with g
 * as a share of the response D, and c the last impulse, a row asks for w + g·D·(j − c) = 0. Rows
 * that could share their loads in several ways then share them as before.
 */
final class NearRows {

    /**
     * Compliance of rows with bounds, as a share of their responses: per metre of tolerance, and at
     * most. Without it, sets of rows that contradict each other by round-off followed each other
     * endlessly and pushed heaps about.
     */
    private static final double NEARNESS = 10;

    private static final double MOST_NEARNESS = 1e-2;

    private final Motions motions;
    private final NeutralRows rows;

    /** Compliance of rows with bounds, as a share of their responses. */
    private final double nearness;

    /** By row: target, compliance and impulse as they were written. */
    private double[] target = new double[64];

    private double[] give = new double[64];
    private double[] last = new double[64];

    NearRows(Motions motions, NeutralRows rows, Accuracy accuracy) {
        this.motions = motions;
        this.rows = rows;
        boolean isExact = Effort.isExact(accuracy);
        nearness = isExact ? 0 : Math.min(MOST_NEARNESS, NEARNESS * accuracy.impactTolerance());
    }

    /** Begins with rows that were just written, with the impulses of the last kick. */
    void begin() {
        if (target.length < rows.count) {
            target = new double[rows.bodies.length];
            give = new double[rows.bodies.length];
            last = new double[rows.bodies.length];
        }
        System.arraycopy(rows.target, 0, target, 0, rows.count);
        System.arraycopy(rows.give, 0, give, 0, rows.count);
        System.arraycopy(rows.impulse, 0, last, 0, rows.count);
    }

    /** Whether rows with bounds are to be kept near their last impulses. */
    boolean areWanted() {
        return nearness > 0 && mayBeIndeterminate();
    }

    /** Gives a row a compliance towards changes of its last impulse. */
    void keep(int row, double before) {
        double more = nearness * rows.response[row];
        rows.give[row] += more;
        rows.target[row] += more * before;
    }

    /**
     * Speed that a row keeps since it is kept near its last impulse. All its work over many kicks
     * is at most what such a compliance stores, since j·(c − j) ≤ (c² − j²)/2.
     */
    double speedOf(int row) {
        double more = rows.give[row] - give[row];
        return rows.target[row] - target[row] - more * rows.impulse[row];
    }

    /**
     * Writes targets and compliances again as they were; friction gets a compliance towards changes
     * of its last impulse, as a share of its response.
     */
    void soften(double share) {
        for (int row = 0; row < rows.count; row++) {
            boolean isFriction = rows.contact[row] != NeutralRows.NONE && !rows.isPoint(row);
            rows.target[row] = target[row];
            rows.give[row] = give[row];
            if (isFriction) {
                rows.give[row] = share * rows.response[row];
                rows.target[row] += rows.give[row] * last[row];
            }
        }
    }

    /**
     * Whether rows may share their loads in more than one way: more of them hold than bodies have
     * degrees of freedom. Limits do not count, since most are not reached, nor do springs. Friction
     * counts only if there is a brake: two bodies that lie still on friction would otherwise creep
     * to where it would have held them anyway.
     */
    private boolean mayBeIndeterminate() {
        int free = 0;
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            free += motions.data[at + Motions.INVERSE_MASS] > 0 ? 2 : 0;
            free += motions.data[at + Motions.INVERSE_INERTIA] > 0 ? 1 : 0;
        }
        int hold = 0;
        int rub = 0;
        boolean isBraked = false;
        for (int row = 0; row < rows.count; row++) {
            boolean isOfJoint = rows.joint[row] != NeutralRows.NONE;
            boolean isLimit = isOfJoint && rows.holdsPlace[row] && !rows.isEquation(row);
            boolean isSoft =
                    isOfJoint && (rows.give[row] > 0 || rows.lower[row] == rows.upper[row]);
            boolean isOfLoad = rows.load[row] != NeutralRows.NONE;
            hold += isLimit || isSoft || isOfLoad ? 0 : 1;
            rub += isOfLoad ? 1 : 0;
            isBraked |= isOfJoint && !isLimit && !isSoft && !rows.isEquation(row);
        }
        return hold + (isBraked ? rub : 0) > free;
    }
}
