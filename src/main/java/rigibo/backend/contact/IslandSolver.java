package rigibo.backend.contact;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.contact.hold.Repose;
import rigibo.backend.contact.row.CarriedFrame;
import rigibo.backend.contact.row.DragKick;
import rigibo.backend.contact.row.FreshRows;
import rigibo.backend.contact.row.IslandForces;
import rigibo.backend.contact.row.IslandResults;
import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Landings;
import rigibo.backend.contact.row.LateJoiners;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.OwnLoads;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedTurns;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.contact.row.SharedRows;
import rigibo.backend.contact.row.Straightness;
import rigibo.backend.contact.row.WarmStart;
import rigibo.backend.contact.solve.ContactSweep;
import rigibo.backend.contact.solve.EnergyBalance;
import rigibo.backend.contact.solve.EnergyGuard;
import rigibo.backend.contact.solve.OverlapSolver;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.Correction;
import rigibo.backend.setup.SolveMethod;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.IslandWork;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.team.Team;

/**
 * Advances islands by one step, one after the other. The solver owns all state it works with, and
 * how an island is solved depends on nothing outside that island.
 */
final class IslandSolver {

    /**
     * Share of a substep that stands for no time. It is not 0, so that the speed at which a gap of
     * round-off may close, gap over time, stays negligible.
     */
    private static final double NO_TIME = 1e-3;

    /** Finest accuracy of passes, as a share of the island's fastest speed. */
    private static final double FINEST_OF_PASSES = 1e-4;

    /**
     * Greatest speed that rows which did not converge may leave, as a multiple of the fastest speed
     * before the step; after eliminations.
     */
    private static final double MOST_LEVERAGE = 2;

    /** Greatest speed that passes may leave, as a multiple of that fastest speed. */
    private static final double MOST_LEVERAGE_OF_PASSES = 8;

    /**
     * Upper bound on the velocity change of one impulse, as a multiple of the island's fastest
     * speed. A box of 10,000 times the mass of the one below it needs that much. Without the bound,
     * a body wedged between two others is squeezed ever harder without effect, until its impulses
     * lose their digits.
     */
    private static final double MOST_STRESS = 1e6;

    /**
     * Upper bound on a contact's warm start for passes, as a multiple of the impulse in the kick
     * before the last. Loads that passes left too small can grow again, while the impulse of an
     * impact is not repeated.
     */
    private static final double MOST_GROWTH = 2;

    /** Largest rotation in a step, rad, up to which loads are taken over to the next step. */
    private static final double MOST_TURN = 0.5;

    /** Gap in widths that counts as closed in a calm island if the contact carries a load. */
    private static final double CLOSED = 3e-5;

    /** Passes over the loads that bodies carry before they are struck. */
    private static final int PASSES_OVER_LOADS = 2;

    private final Islands islands;
    private final Accuracy accuracy;
    private final Motions motions;
    private final PackedContacts contacts = new PackedContacts();
    private final RowBuilder builder;
    private final Kick kick;
    private final WarmStart warmStart;
    private final OverlapSolver overlap;
    private final EnergyGuard guard;
    private final LateJoiners lateJoiners;
    private final Landings landings;
    private final EnergyBalance balance;
    private final Repose repose;
    private final EliminationBudget budget;
    private final Rounds rounds;
    private final Passes passes;
    private final DeclaredRows declared;
    private final IslandResults results;
    private final CarriedFrame frame;
    private final Substeps fewer;

    /** Whether contacts are measured again within a substep; not at DRAFT. */
    private final boolean isFollowed;

    /** Whether the packed island is solved whole, by elimination. */
    private boolean isWhole;

    /** Highest speed before contacts are solved, m/s. */
    private double fastest;

    /** Highest speed that rows which did not converge may leave in this step, m/s. */
    private double limit;

    /** Whether every body of the packed island was found to be held in place. */
    private boolean isHeld;

    /** Number of substeps for the packed island. */
    private int substeps;

    /** End of the last kick, s after the step's start. */
    private double middle;

    /** Length of the last kick, s. */
    private double kicked;

    /**
     * Length of the last part, s, usually a substep; 0 if velocities are those of the present time.
     */
    private double lastPart;

    /**
     * A solver for the declared effects at an accuracy; {@code forces} are those that vary along
     * the path, null if there are none. A team shares large islands; it is null for one worker.
     */
    IslandSolver(
            DataStorage data,
            Narrowphase narrowphase,
            Effects effects,
            Accuracy accuracy,
            IslandForces forces,
            Team team) {
        motions = new Motions(data.bodies.turns());
        frame = new CarriedFrame(data, motions);
        fewer = new Substeps(data);
        islands = data.islands;
        this.accuracy = accuracy;
        PackedTurns turns = motions.turns ? new PackedTurns(data.bodies, motions) : null;
        builder = new RowBuilder(data, motions, contacts, turns);
        warmStart = new WarmStart(motions, contacts);
        guard = new EnergyGuard(motions, contacts);
        results = new IslandResults(data, motions, contacts, turns);
        boolean drags = effects.declares(Drag.class);
        DragKick drag = drags ? new DragKick(data.bodies, motions) : null;
        kick = new Kick(data.bodies, motions, forces, drag, turns);
        lateJoiners = new LateJoiners(data.bodies, motions, contacts);
        overlap = new OverlapSolver(data.bodies, motions, contacts, accuracy);
        boolean isCorrecting = accuracy.correction() == Correction.SOFT;
        OverlapSolver wanted = isCorrecting ? overlap : null;
        OwnLoads own = new OwnLoads(data.bodies, motions, contacts);
        repose = new Repose(data, motions, contacts, own, wanted, kick, builder, accuracy);
        balance = new EnergyBalance(data.bodies, motions, contacts);
        Straightness straight = new Straightness(motions, accuracy);
        isFollowed = straight.follows;
        landings = new Landings(motions, contacts, kick, accuracy);
        SharedRows shared = new SharedRows(team, contacts);
        FreshRows fresh = new FreshRows(data, narrowphase, motions, contacts, builder, shared);
        declared =
                new DeclaredRows(data, effects, motions, contacts, kick, fresh, straight, shared);
        boolean isBlock = accuracy.contactSolver() != ContactSolver.SEQUENTIAL;
        ContactSweep sweep =
                new ContactSweep(
                        data.bodies, motions, contacts, declared.rubbing(), isBlock, shared);
        budget = new EliminationBudget(motions, contacts, accuracy);
        rounds = new Rounds(motions, contacts, own, guard, sweep, overlap, budget, accuracy);
        passes = new Passes(motions, contacts, declared, kick, guard, sweep, overlap, accuracy);
    }

    /** Advances an island to the end of a step of {@code dt} seconds. */
    void solve(int island, double dt) {
        frame.enter(island);
        boolean lasts =
                repose.lasts(island, dt) && (!repose.isOverlapping() || isBlocked(island, dt));
        double start = lateJoiners.startOf(islands, island);
        boolean isAdvanced = !lasts && dt > start;
        if (lasts) {
            results.goOn(island, dt);
            contacts.work.solve(SolveMethod.AT_REST, 0);
        } else if (isAdvanced) {
            int usual = fewer.of(island, dt, accuracy.substeps());
            substeps = declared.substepsFor(island, dt - start, usual);
            advance(island, start, (dt - start) / substeps, dt);
        }
        frame.leave(island, dt);
        if (isAdvanced) {
            results.quarantine();
        }
    }

    /** Whether a held island has overlap, but none that could be removed. */
    private boolean isBlocked(int island, double dt) {
        double h = dt / fewer.of(island, dt, accuracy.substeps());
        builder.build(island, h / 2);
        return passes.areBlocked(h);
    }

    /** Work counters of the islands since the last call. */
    IslandWork work() {
        return contacts.work;
    }

    private void advance(int island, double start, double h, double dt) {
        builder.build(island, h / 2);
        declared.begin(h, h / 2, budget.ofImpacts(substeps + 1));
        declared.foresee(dt - start);
        warmStart.prepare();
        passes.begin(dt, substeps);
        repose.begin();
        boolean isCalm = repose.isCalm(dt);
        overlap.prepare(isCalm);
        isWhole = rounds.prepare(isCalm, kick.strongest() * dt);
        lateJoiners.delay(start, h);
        landings.begin();
        balance.begin();
        isHeld = false;
        middle = start;
        kicked = h / 2;
        lastPart = 0;
        boolean wasStill = repose.isStill(dt, share());
        for (int substep = 0; substep < substeps; substep++) {
            advanceSubstep(start, h, substep, dt, substep == 0 && wasStill);
        }
        if (isHeld) {
            finishHeld();
        } else {
            finish(h, dt);
            if (declared.isAnyBent()) {
                balance.settle();
            }
        }
        SolveMethod method = isWhole ? SolveMethod.ELIMINATION : SolveMethod.PASSES;
        contacts.work.solve(method, declared.rowCount() + contacts.count);
        results.store(2 * kicked, dt - start);
        declared.store(2 * kicked);
    }

    /** Makes a substep of h seconds, in parts if something lands within it. */
    private void advanceSubstep(double start, double h, int substep, double dt, boolean wasStill) {
        landings.beginSubstep();
        double gone = 0;
        while (gone < h) {
            double time = start + substep * h + gone;
            double left = h - gone;
            if (declared.measureAnew(substep, gone == 0, time, dt - time)) {
                rounds.forget();
            }
            if (isWhole && landings.haveLanded(h)) {
                // Contacts carried up to here without the landed points, and carry with them from
                // here on.
                endKick(time, h, substep);
                landings.close();
            }
            landings.keepClosed(h);
            double known = landings.areLookedFor() ? declared.untilNewPoints() : left;
            double part = landings.untilNext(left, known);
            declared.bend(part, part);
            beginPart(time, part, substep, dt - time);
            boolean isAll = part == h;
            boolean rests =
                    wasStill && isAll && isCarried(start, h)
                            || solvePart(start, part, substep, isAll, dt - time);
            if (rests) {
                rest();
                middle = dt - h / 2;
            }
            gone = part < left ? gone + part : h;
        }
    }

    /**
     * Kicks all bodies up to the middle of a part and warm starts the contacts; {@code left}
     * seconds of the step are to go.
     */
    private void beginPart(double time, double part, int substep, double left) {
        kick.remember();
        kick.accelerate(middle, time + part / 2);
        middle = time + part / 2;
        fastest = motions.fastest();
        setLimit(substep);
        if (!isWhole) {
            // The warm start may give bodies wrong speeds until contacts are solved; an impact
            // resolved at such speeds could not be undone.
            declared.strikeApart(part, substep);
            declared.measureStrays(left);
        }
        guard.begin();
        begin((lastPart + part) / 2, substep);
        lastPart = part;
    }

    /** Makes the first substep; returns whether it shows that the island rests. */
    private boolean solvePart(double start, double h, int substep, boolean mayRest, double left) {
        if (isWhole) {
            if (declared.mayStrike(h, substep)) {
                // At speeds that come from a load which is gone, impacts would add energy.
                warmStart.takeBackWhatParts(substep, PASSES_OVER_LOADS);
            }
            if (!declared.strikeJointly(h, substep)) {
                strikeUnloaded(h, substep);
            }
            if (declared.measureStrays(left)) {
                rounds.forget();
            }
        }
        if (isWhole && rounds.isCalm()) {
            closeLoadedGaps(CLOSED);
        }
        isWhole = isWhole && rounds.settle(h, kicked, substep, fastest, limit);
        if (!isWhole) {
            passes.advance(h, kicked, substep, unanswered(), limit, left);
            return false;
        }
        if (mayRest && substep == 0 && repose.isFound(start, h, substeps, kicked)) {
            return true;
        }
        repose.haltHeld(kicked);
        contacts.addUpImpulses(1);
        if (!isFollowed) {
            motions.drift(h);
        } else if (passes.drift(h, substep, unanswered(), limit, left)) {
            rounds.forget();
        }
        rounds.takeOverlapBack(h, substep);
        return false;
    }

    /** Resolves impacts, at velocities without the warm start. */
    private void strikeUnloaded(double h, int substep) {
        warmStart.add(-1, substep);
        declared.strikeApart(h, substep);
        warmStart.add(1, substep);
    }

    /**
     * Lets contacts keep the impulses of the first substep in all others. No body moves, since the
     * remaining speeds are below the threshold.
     */
    private void rest() {
        contacts.addUpImpulses(2 * substeps - 1);
        substeps = 1;
    }

    /** Warm starts a kick of a length in s from the kick before. */
    private void begin(double length, int substep) {
        double scale = length / kicked;
        kicked = length;
        if (isWhole && contacts.strongestAnswer() > MOST_STRESS * fastest) {
            contacts.unload();
        }
        if (substep > 0) {
            warmStart.leaveOutImpacts(isWhole ? 1 : MOST_GROWTH);
        }
        warmStart.scaleBefore(scale, substep);
        warmStart.apply(scale, substep);
        // A warm start gives bodies wrong speeds if the load that it carried is gone.
        guard.limitSpeed(leverage() * fastest);
        if (isWhole) {
            double turn = MOST_TURN / substeps;
            guard.limitGrowth(turn * turn);
        }
    }

    /**
     * Passes may also separate bodies as fast as overlap is removed. Speed that bodies gain within
     * the step without contacts must be within the limit, or all impulses would be scaled down.
     */
    private void setLimit(int substep) {
        if (substep == 0) {
            double parting = isWhole ? 0 : Recovery.MOST_PUSH * contacts.widest();
            limit = Math.max(leverage() * fastest, parting);
        } else {
            limit = Math.max(limit, fastest);
        }
    }

    /** The limit factor; passes never converge fully, and only need protection from explosions. */
    private double leverage() {
        return isWhole ? MOST_LEVERAGE : MOST_LEVERAGE_OF_PASSES;
    }

    /** Share of the fastest speed that counts as solved. */
    private double share() {
        return isWhole ? rounds.share() : Math.max(rounds.share(), FINEST_OF_PASSES);
    }

    /**
     * The fastest speed after the warm start, m/s; in a heap that calms down it is the speed of its
     * own motion and not that of a kick.
     */
    private double unanswered() {
        return Math.min(fastest, motions.fastest());
    }

    private boolean isCarried(double start, double h) {
        isHeld = repose.isCarried(start, h, substeps, kicked);
        return isHeld;
    }

    /** Ends the step of an island at rest: the second half kick repeats the first. */
    private void finishHeld() {
        motions.halt();
        contacts.addUpImpulses(1);
    }

    /** Ends the last substep. */
    private void finish(double h, double dt) {
        if (declared.measureAnew(substeps, true, dt, 0)) {
            rounds.forget();
        }
        endKick(dt, h, substeps);
    }

    /**
     * Makes the second half of the last kick, after which velocities are those at the end of the
     * step. No body moves in it, so an island that is solved whole ignores gaps that would close in
     * the next substep of h seconds. Passes consider them, since their errors would grow otherwise.
     */
    private void endKick(double time, double h, int substep) {
        declared.bend(0, isWhole ? 0 : h);
        if (isWhole) {
            closeLoadedGaps(PairTolerances.TOUCHING_GAP);
        }
        kick.accelerate(middle, time);
        middle = time;
        fastest = motions.fastest();
        limit = Math.max(limit, fastest);
        guard.begin();
        begin(lastPart / 2, substep);
        lastPart = 0;
        isWhole =
                isWhole
                        && declared.strikeAtOnce(h * NO_TIME, substep)
                        && rounds.settle(h * NO_TIME, kicked, substep, fastest, limit);
        if (isWhole) {
            repose.haltHeld(kicked);
            contacts.addUpImpulses(1);
        } else {
            declared.leaveOpen(substep);
            passes.hold(h, kicked, substep, unanswered(), limit);
        }
    }

    /**
     * Closes gaps that round-off or the error of passes opened under contacts which carried a load
     * in the last substep. Otherwise such a contact would fall for half a kick, and in a calm
     * island the redundant points could not all close their gaps at once.
     */
    private void closeLoadedGaps(double share) {
        double[] d = contacts.data;
        for (int row = 0; row < contacts.count; row++) {
            int at = row * PackedContacts.STRIDE;
            double touching = share * d[at + PackedContacts.WIDTH];
            for (int point = 0; point < contacts.points[row]; point++) {
                double gap = motions.gap(contacts, row, point);
                if (d[at + PackedContacts.IMPULSE0 + point] > 0 && gap > 0 && gap < touching) {
                    d[at + PackedContacts.GAP0 + point] -= gap;
                }
            }
        }
    }
}
