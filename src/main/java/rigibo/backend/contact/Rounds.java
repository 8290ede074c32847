package rigibo.backend.contact;

import rigibo.backend.contact.row.Effort;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.OwnLoads;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.solve.ContactSweep;
import rigibo.backend.contact.solve.DirectSolver;
import rigibo.backend.contact.solve.EnergyGuard;
import rigibo.backend.contact.solve.Halfway;
import rigibo.backend.contact.solve.OverlapSolver;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.Correction;

/**
 * Solves a small island until it converges, substep by substep, in rounds. A round is a pass, which
 * measures the residual, and an elimination. An island that exceeds its budget of work is restored
 * and left to {@link Passes}.
 */
final class Rounds {

    /** Allowed residual as a share of the fastest speed, per metre of impact tolerance. */
    private static final double SETTLED = 1e-2;

    /**
     * Allowed residual of a body in a calm island, as a share of its own loads. A body at rest may
     * lack a larger share of its support, so that an unsupported body can be told from an error.
     */
    private static final double SETTLED_IF_CALM = 5e-10;

    /**
     * Allowed residual in a calm island whose rounds no longer converge, because rows are
     * compliant, or because elimination would have to try rows one after the other.
     */
    private static final double LEFT_IF_CALM = 1e-7;

    /**
     * Allowed residual after the usual number of rounds, where they no longer converge, as a
     * multiple of the usual one. Two faces that hold a body at slightly different angles leave such
     * a residual: elimination finds nothing to change, and passes shift the same load for ever.
     */
    private static final double TIMES_LEFT_LATER = 10;

    /** Share of the largest change of speed below which a change is round-off: about 64 ulp. */
    private static final double CHANGE_ROUND_OFF = 1e-14;

    /** Rounds per substep in addition to one for each substep of the accuracy. */
    private static final int LEAST_ROUNDS = 4;

    /**
     * Largest residual of a round, as a share of that of the round before; a round with a larger
     * one is undone by half.
     */
    private static final double SHRINKS = 0.5;

    /** Least residual that counts as no nearer than another one, as a share of that one. */
    private static final double NO_NEARER = 0.99;

    /**
     * Number of rounds in turn, as a multiple of the usual number, that may come no nearer: rounds
     * that cycle would go on cycling.
     */
    private static final int STALLED = 2;

    /**
     * Largest residual that rounds may leave, as a share of the fastest speed; islands with a
     * larger one are left to passes, which do better.
     */
    private static final double GIVEN_UP = 0.03;

    /**
     * Factor on the rounds from which on the best of them counts even if the budget is spent: that
     * of a ratio of masses of 100, at which passes do worse.
     */
    private static final double LOPSIDED = 25;

    /** Least factor of the rounds of a moving island where work has no limit. */
    private static final double TIMES_UNLIMITED = 8;

    /** Rounds before Newton's method is tried again; twice as many each time. */
    private static final int WAIT = 4;

    /** Number of rounds that begin with a single pass; most islands need no more rounds. */
    private static final int QUICK = 2;

    /**
     * Most passes of a round where masses differ, unless they differ so much that a share of the
     * factor on the rounds is more: one pass does not show there which contacts carry load.
     */
    private static final int MOST_PASSES = 32;

    /** That share: up to a hundred passes, as few of a thousand bullets need. */
    private static final double PASSES_BY_TIMES = 1 / 3.0;

    private final Motions motions;
    private final PackedContacts contacts;
    private final OwnLoads own;
    private final EnergyGuard guard;
    private final ContactSweep sweep;
    private final OverlapSolver overlap;
    private final EliminationBudget budget;
    private final DirectSolver direct;
    private final Halfway halfway;
    private final Halfway before;
    private final Halfway best;

    /** Whether more rounds are made where masses differ; not at {@code DRAFT}. */
    private final boolean isThorough;

    private final boolean isDirect;
    private final boolean isCorrecting;
    private final int most;

    /** Allowed residual as a share of the fastest speed. */
    private final double share;

    /** Least factor of the rounds of a moving island. */
    private final double leastTimes;

    private boolean isCalm;

    /** Factor on the rounds of the packed island; above 1 where masses differ, and at EXACT. */
    private double times;

    /** Change of speed in a pass after the rounds, m/s; 0 if they converged. */
    private double missed;

    /** Allowed residual in the present round, m/s. */
    private double settled;

    Rounds(
            Motions motions,
            PackedContacts contacts,
            OwnLoads own,
            EnergyGuard guard,
            ContactSweep sweep,
            OverlapSolver overlap,
            EliminationBudget budget,
            Accuracy accuracy) {
        this.motions = motions;
        this.contacts = contacts;
        this.own = own;
        this.guard = guard;
        this.sweep = sweep;
        this.overlap = overlap;
        this.budget = budget;
        int substeps = accuracy.substeps();
        direct = new DirectSolver(motions, contacts, overlap, substeps);
        halfway = new Halfway(motions, contacts);
        before = new Halfway(motions, contacts);
        best = new Halfway(motions, contacts);
        isThorough = Effort.isThorough(accuracy);
        isDirect = accuracy.contactSolver() == ContactSolver.DIRECT;
        isCorrecting = accuracy.correction() == Correction.SOFT;
        most = LEAST_ROUNDS + substeps;
        share = SETTLED * accuracy.impactTolerance();
        leastTimes = Effort.isExact(accuracy) ? TIMES_UNLIMITED : 1;
    }

    /**
     * Prepares the packed island; returns false if it is too large for its budget. A free body
     * gains {@code gained} m/s in the step.
     */
    boolean prepare(boolean isCalm, double gained) {
        this.isCalm = isCalm && !motions.isAnyDriven;
        return isDirect && direct.prepare(budget.ofSubstep(isCalm, gained), this.isCalm, gained);
    }

    /** Whether the packed island is calm. */
    boolean isCalm() {
        return isCalm;
    }

    /** Discards the factorization, since the rows have changed. */
    void forget() {
        direct.forget();
    }

    /** Allowed residual as a share of the fastest speed. */
    double share() {
        return share;
    }

    /**
     * Solves a substep.
     *
     * @param h length of the substep, s
     * @param kicked length of its kick, s
     * @param substep its number
     * @param fastest fastest speed before contacts are solved, m/s
     * @param limit greatest speed that rows which did not converge may leave, m/s
     * @return whether it was solved within the budget; if not, everything is restored
     */
    boolean settle(double h, double kicked, int substep, double fastest, double limit) {
        before.begin();
        direct.begin();
        boolean mayRepeat = isThorough && !isCalm;
        times = mayRepeat ? Math.max(leastTimes, EliminationBudget.timesByMass(motions)) : 1;
        missed = 0;
        boolean isSettled = settleRows(h, kicked, substep, fastest);
        contacts.work.multiplications += direct.work();
        if (areGivenUp(fastest)) {
            before.takeBack();
            return false;
        }
        guard.limitEnergy();
        if (!isSettled) {
            guard.limitSpeed(limit);
        }
        return true;
    }

    /** Whether the rounds did not get near enough to a solution for what they found to count. */
    private boolean areGivenUp(double fastest) {
        boolean isFar = isThorough && missed > GIVEN_UP * fastest;
        return isFar || direct.isSpent() && times < LOPSIDED;
    }

    /**
     * Makes rounds until the residual is small enough, which it is at rest after the first one. A
     * calm island goes on as long as rounds converge.
     *
     * <p>Newton's method is used as long as it converges; a round of it that does not is undone,
     * and elimination continues. Where masses differ and more rounds are made, it is tried again
     * after some of them, since at once it would lead to the same place.
     *
     * <p>Rounds may cycle, since friction and normal loads depend on each other; they end once many
     * in turn came no nearer. In a calm island, where masses differ much, and at {@code EXACT}, the
     * best of them is kept.
     *
     * @return whether the rounds converged
     */
    private boolean settleRows(double h, double kicked, int substep, double fastest) {
        double enough = isCalm ? LEFT_IF_CALM / SETTLED_IF_CALM : 1;
        int newtonFrom = isCalm ? 0 : 1;
        boolean isNewton = false;
        double last = Double.POSITIVE_INFINITY;
        double least = Double.POSITIVE_INFINITY;
        int wait = WAIT;
        int rounds = (int) (most * times);
        int passes = (int) Math.max(Math.min(MOST_PASSES, times), PASSES_BY_TIMES * times);
        int end = STALLED * most;
        for (int i = 0; i < Math.min(rounds, end) && !direct.isSpent(); i++) {
            for (int pass = 1; i >= QUICK && pass < passes; pass++) {
                sweep.once(h, substep);
            }
            double left = left(h, kicked, substep, fastest);
            end = left < NO_NEARER * least ? i + STALLED * most : end;
            if (left < least && isBestKept()) {
                best.begin();
            }
            least = Math.min(left, least);
            boolean isNoNearer = left > SHRINKS * last;
            if (left <= 1 || isNoNearer && last <= (i > most ? TIMES_LEFT_LATER : enough)) {
                if (left > last) {
                    halfway.takeBack();
                }
                return true;
            }
            if (isNewton && isNoNearer) {
                halfway.takeBack();
                newtonFrom = Math.max(most, i + wait);
                wait *= 2;
                isNoNearer = false;
                left = last;
            }
            halfway.begin();
            isNewton = i >= newtonFrom && direct.solveByNewton(h, substep, settled);
            if (!isNewton) {
                direct.solve(h, substep, settled);
                if (isNoNearer) {
                    halfway.end();
                }
            }
            last = left;
        }
        if (isBestKept()) {
            best.takeBack();
        }
        missed = isCalm ? 0 : sweep.once(h, substep);
        return false;
    }

    /** Whether the best of the rounds is kept if they do not converge. */
    private boolean isBestKept() {
        return isCalm || leastTimes > 1 || times >= LOPSIDED;
    }

    /**
     * The residual that a pass finds, as a multiple of the allowed one; 0 if it is small enough.
     */
    private double left(double h, double kicked, int substep, double fastest) {
        double change = sweep.once(h, substep);
        if (!isCalm) {
            settled = Math.max(share * fastest, CHANGE_ROUND_OFF * contacts.strongestAnswer());
            return change <= settled ? 0 : change / settled;
        }
        own.measure(kicked);
        settled = SETTLED_IF_CALM * leastOwn();
        return changeOfOwn() / SETTLED_IF_CALM;
    }

    /** Largest change of a body's speed in the last pass, as a share of its own loads. */
    private double changeOfOwn() {
        double most = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            double change = sweep.change(entry);
            most = change > 0 ? Math.max(most, change / own.of(entry)) : most;
        }
        return most;
    }

    /** Least speed that any body would gain by its own loads, m/s. */
    private double leastOwn() {
        double least = Double.POSITIVE_INFINITY;
        for (int entry = 1; entry < motions.count; entry++) {
            double ofEntry = own.of(entry);
            least = ofEntry > 0 ? Math.min(least, ofEntry) : least;
        }
        return least;
    }

    /** Removes overlap by moving bodies, after a substep of h seconds. */
    void takeOverlapBack(double h, int substep) {
        if (isCorrecting && overlap.isJammed()) {
            overlap.partJammed(h, substep);
        } else if (isCorrecting && overlap.findDeep(substep)) {
            overlap.begin();
            direct.correct(h, substep);
            overlap.correct(h, substep);
            overlap.end(h, substep);
        }
    }
}
