package rigibo.backend.contact;

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
 * Solves a small island to the end, substep by substep, in rounds of one pass, which finds what is
 * left, and one elimination. An island that takes more work than it is worth is restored as it was
 * and left to {@link Passes}.
 */
public final class Rounds {

    /** Share of the fastest speed that may be left unsolved, per metre of the tolerance. */
    private static final double SETTLED = 1e-2;

    /**
     * Share of its own loads that may be left unsolved of a body in a calm island: less than a body
     * at rest may be held too little, so that what nothing holds is told from an error.
     */
    private static final double SETTLED_IF_CALM = 5e-10;

    /**
     * The share that may be left where rounds come no nearer: what rows give way by, and rows that
     * elimination would have to try one after the other.
     */
    private static final double LEFT_IF_CALM = 1e-7;

    /** Share of the strongest answer below which a change is round-off: some 64 ulp. */
    private static final double ROUND_OFF = 1e-14;

    /** Rounds that a substep is given beside one for each substep of the accuracy. */
    private static final int LEAST_ROUNDS = 4;

    /**
     * A round whose changes are larger than this share of those of the round before is taken back
     * by half.
     */
    private static final double SHRINKS = 0.5;

    /**
     * How many times the work of passes elimination is worth among bodies of one mass that keep
     * nothing of what they close with: passes are soon done there.
     */
    private static final double WORTH = 0.25;

    /**
     * How many times it is worth for a single body on what nobody moves, with its three unknowns,
     * and for what a driven body presses, which no load can stop.
     */
    private static final double WORTH_ALONE = 8;

    /**
     * How many times that it is worth, at most, where passes take long: with bodies that differ in
     * mass, where a bullet is through a box before they are done, and with elastic ones, which lose
     * nothing of what passes leave.
     */
    private static final double MOST_WORTH = 100;

    /**
     * How many times the work of passes elimination is worth in an island that hardly moves: once
     * solved it rests, and costs nothing any more.
     */
    private static final double WORTH_IF_CALM = 24;

    /** Multiplications that the smallest island is worth in a substep: a microsecond. */
    private static final double LEAST_WORTH = 2_500;

    /** Multiplications that the impacts of the smallest island are worth in a step. */
    private static final double LEAST_WORTH_OF_IMPACTS = 1e5;

    /** What passes take in multiplications: by a contact in a substep, mostly six times. */
    private static final double WORK_OF_PASSES = 6 * 60;

    /**
     * Share of the fastest speed by which rounds may miss: what they leave worse than passes would
     * is left to passes.
     */
    private static final double GIVEN_UP = 0.03;

    /** How many times as many rounds an island that moves is given where no work is too much. */
    private static final double TIMES_UNLIMITED = 8;

    /** Rounds after which Newton's method is tried again at first; twice as many each time. */
    private static final int WAIT = 4;

    /** Rounds that begin with one pass, as most islands need no more. */
    private static final int QUICK = 2;

    /**
     * Passes of a round at most, where masses differ: which contacts carry is hard to tell there
     * from one pass.
     */
    private static final int MOST_PASSES = 32;

    private final Motions motions;
    private final PackedContacts contacts;
    private final OwnLoads own;
    private final DeclaredRows declared;
    private final EnergyGuard guard;
    private final ContactSweep sweep;
    private final OverlapSolver overlap;
    private final DirectSolver direct;
    private final Halfway halfway;
    private final Halfway before;
    private final Halfway best;

    /** Whether rounds go on where masses differ; at a draft's accuracy what is hard is left. */
    private final boolean isThorough;

    private final boolean isDirect;
    private final boolean isCorrecting;
    private final int most;

    /** Share of the fastest speed that counts as solved. */
    private final double share;

    /** Multiplications that passes take for a contact in a substep; without a limit at EXACT. */
    private final double ofPasses;

    private final double worthIfCalm;

    /** How many times as many rounds an island that moves is given at least. */
    private final double leastTimes;

    private boolean isCalm;

    /** Change of speed that the last pass found where rounds were not enough, m/s. */
    private double missed;

    /** Speed that counts as none in the present round, m/s. */
    private double settled;

    public Rounds(
            Motions motions,
            PackedContacts contacts,
            OwnLoads own,
            DeclaredRows declared,
            EnergyGuard guard,
            ContactSweep sweep,
            OverlapSolver overlap,
            Accuracy accuracy) {
        this.motions = motions;
        this.contacts = contacts;
        this.own = own;
        this.declared = declared;
        this.guard = guard;
        this.sweep = sweep;
        this.overlap = overlap;
        int substeps = accuracy.substeps();
        direct = new DirectSolver(motions, contacts, overlap, substeps);
        halfway = new Halfway(motions, contacts);
        before = new Halfway(motions, contacts);
        best = new Halfway(motions, contacts);
        isThorough = substeps >= Accuracy.GAME.substeps();
        isDirect = accuracy.contactSolver() == ContactSolver.DIRECT;
        isCorrecting = accuracy.correction() == Correction.SOFT;
        most = LEAST_ROUNDS + substeps;
        share = SETTLED * accuracy.impactTolerance();
        // From EXACT on elimination is worth any work.
        boolean isLimited = substeps < Accuracy.EXACT.substeps();
        double coarser = Math.min(1, substeps / (double) Accuracy.GAME.substeps());
        ofPasses = isLimited ? WORK_OF_PASSES : Double.POSITIVE_INFINITY;
        leastTimes = isLimited ? 1 : TIMES_UNLIMITED;
        worthIfCalm =
                isLimited ? WORTH_IF_CALM * coarser * WORK_OF_PASSES : Double.POSITIVE_INFINITY;
    }

    /** Begins the packed island, unless it is too large. */
    boolean prepare(boolean isCalm) {
        this.isCalm = isCalm && !motions.isAnyDriven;
        double moving = ofPasses * timesOfPasses();
        double ofContact = isCalm ? Math.max(worthIfCalm, moving) : moving;
        return isDirect && direct.prepare(Math.max(LEAST_WORTH, ofContact * contacts.count));
    }

    /** How many times the work of passes elimination of an island that moves is worth. */
    private double timesOfPasses() {
        double elasticity = contacts.highestElasticity();
        double lost = 1 - elasticity * elasticity;
        double byElasticity = WORTH / Math.max(lost, 1 / MOST_WORTH);
        double moving = Math.max(byElasticity, timesByMass(motions));
        boolean isAlone = motions.count == 2 || motions.isAnyDriven;
        return isAlone ? Math.max(WORTH_ALONE, moving) : moving;
    }

    /** How many times the work of passes elimination is worth for the sake of masses. */
    static double timesByMass(Motions motions) {
        return Math.min(MOST_WORTH, WORTH * motions.massRatio());
    }

    /** Whether the packed island hardly moves. */
    boolean isCalm() {
        return isCalm;
    }

    /** Multiplications that the impacts of so many kicks are worth, be the island calm or not. */
    double worthOfImpacts(int kicks) {
        return Math.max(LEAST_WORTH_OF_IMPACTS, ofPasses * kicks * contacts.count);
    }

    /** The rows are not what they were. */
    void forget() {
        direct.forget();
    }

    /** Share of the fastest speed that counts as solved. */
    double share() {
        return share;
    }

    /**
     * Solves a substep of h seconds, whose kick lasted {@code kicked} seconds, in which nothing
     * went faster than {@code fastest} m/s before contacts answered, and nothing that is not solved
     * may go faster than a limit in m/s.
     *
     * @return whether it was worth it; if not, everything is as it was
     */
    boolean settle(double h, double kicked, int substep, double fastest, double limit) {
        before.begin();
        direct.begin();
        boolean isSettled = settleRows(h, kicked, substep, fastest);
        contacts.work.multiplications += direct.work();
        if (direct.isSpent() || isThorough && !isSettled && missed > GIVEN_UP * fastest) {
            before.takeBack();
            return false;
        }
        guard.limitEnergy();
        if (!isSettled) {
            guard.limitSpeed(limit);
        }
        return true;
    }

    /**
     * Goes on until nothing is left, which at rest it is after the first round; a calm island goes
     * on as long as that brings it nearer. Newton's method is tried as long as it does; where it
     * does not, its round is taken back and elimination goes on; where masses differ, and more
     * rounds are made, it is tried again from time to time: at once it would only lead to the same
     * place. Rounds of a calm island may take turns for ever, and many of one that moves lead
     * astray; then the best of them counts.
     */
    private boolean settleRows(double h, double kicked, int substep, double fastest) {
        double enough = isCalm ? LEFT_IF_CALM / SETTLED_IF_CALM : 1;
        int newtonFrom = isCalm ? 0 : 1;
        boolean isNewton = false;
        double last = Double.POSITIVE_INFINITY;
        double least = Double.POSITIVE_INFINITY;
        double times = isThorough && !isCalm ? Math.max(leastTimes, timesByMass(motions)) : 1;
        int wait = WAIT;
        int rounds = (int) (most * times);
        int passes = (int) Math.min(MOST_PASSES, times);
        for (int i = 0; i < rounds && !direct.isSpent(); i++) {
            for (int pass = 1; i >= QUICK && pass < passes; pass++) {
                sweep.once(h, substep);
            }
            double left = left(h, kicked, substep, fastest);
            if (left < least && isBestKept()) {
                least = left;
                best.begin();
            }
            boolean isNoNearer = left > SHRINKS * last;
            if (left <= 1 || isNoNearer && last <= enough) {
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
            isNewton = i >= newtonFrom && direct.solveByNewton(h, substep, settled, isCalm);
            if (!isNewton) {
                direct.solve(h, substep, settled, isCalm);
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

    /** Whether the best of the rounds counts, where none settles all. */
    private boolean isBestKept() {
        return isCalm || leastTimes > 1;
    }

    /** What a pass over the rows finds left, as a multiple of what may be left; 0 if nothing. */
    private double left(double h, double kicked, int substep, double fastest) {
        double change = sweep.once(h, substep);
        if (!isCalm) {
            settled = Math.max(share * fastest, ROUND_OFF * contacts.strongestAnswer());
            return change <= settled ? 0 : change / settled;
        }
        own.measure(kicked);
        settled = SETTLED_IF_CALM * leastOwn();
        return changeOfOwn() / SETTLED_IF_CALM;
    }

    /** The most that the last pass changed the speed of a body, as a share of its own loads. */
    private double changeOfOwn() {
        double most = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            double change = sweep.change(entry);
            most = change > 0 ? Math.max(most, change / own.of(entry)) : most;
        }
        return most;
    }

    /** The least that any body would gain by its own loads, m/s. */
    private double leastOwn() {
        double least = Double.POSITIVE_INFINITY;
        for (int entry = 1; entry < motions.count; entry++) {
            double ofEntry = own.of(entry);
            least = ofEntry > 0 ? Math.min(least, ofEntry) : least;
        }
        return least;
    }

    /** Takes overlap back by moving bodies, after a substep of h seconds. */
    void takeOverlapBack(double h, int substep) {
        if (isCorrecting && overlap.isJammed()) {
            overlap.partJammed(h, substep);
        } else if (isCorrecting) {
            overlap.begin();
            direct.correct(h, substep);
            overlap.correct(h, substep);
            overlap.end(h, substep);
        }
    }
}
