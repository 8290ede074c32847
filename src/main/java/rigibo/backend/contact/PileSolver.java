package rigibo.backend.contact;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.ShapeKind;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.Correction;
import rigibo.backend.setup.SolveMethod;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.PairTolerances;

/** Advances all piles by one step, island by island. */
public final class PileSolver {

    /** Share of a substep that stands for no time at all, yet lets a gap of round-off rest. */
    private static final double NO_TIME = 1e-3;

    /** Share of what a free body would gain in a step up to which a pile is calm. */
    private static final double CALM = 0.25;

    /** Share of the fastest speed that may be left unsolved, per metre of the tolerance. */
    private static final double SETTLED = 1e-2;

    /** Share of the strongest answer below which a change is round-off: some 64 ulp. */
    private static final double ROUND_OFF = 1e-14;

    /**
     * Rounds that a small pile is given per substep beside one for each substep of the accuracy.
     */
    private static final int LEAST_ROUNDS = 4;

    /** How many times faster than anything in the step before rows not solved may leave a body. */
    private static final double MOST_LEVERAGE = 2;

    private static final double MOST_LEVERAGE_IF_LARGE = 8;

    /**
     * How many times faster than anything moves an impulse by itself may make what it pushes. A box
     * of 10,000 times the mass of the one it lies on asks for that; what is wedged between two
     * others can be squeezed ever harder, in vain, and loses hold of its balance.
     */
    private static final double MOST_STRESS = 1e6;

    /** Turn in a step, rad, by which loads may miss what they carried in the substep before. */
    private static final double MOST_TURN = 0.5;

    /** Share of its bodies that have corners from which on a wide pile is built, not poured. */
    private static final double LEAST_ANGULAR = 0.1;

    /** A round that changes more than this share of what the last one did goes half its way. */
    private static final double SHRINKS = 0.5;

    private final Bodies bodies;
    private final Islands islands;
    private final Counters counters;
    private final Accuracy accuracy;
    private final boolean isCorrecting;
    private final Motions motions;
    private final Rows rows = new Rows();
    private final RowBuilder builder;
    private final Kick kick;
    private final WarmStart warmStart;
    private final NormalSolver normals;
    private final OverlapSolver overlap;
    private final EnergyGuard guard;
    private final Halfway halfway;
    private final DirectSolver direct;
    private final SplitSolver split;

    private final LateJoiners lateJoiners;
    private final Repose repose;
    private final Passes passes;
    private final boolean isDirect;
    private final DeclaredRows declared;
    private final PileResults results;

    /** Which of the two solves the packed island whole, null where it is too large for both. */
    private WholeSolver whole;

    /** Whether hardly anything in the packed island has a face to stand on. */
    private boolean isRound;

    /** The highest speed before contacts answer, m/s. */
    private double fastest;

    /** The highest speed at which rows that were not solved may leave a body in this step, m/s. */
    private double limit;

    /** What may be left in a small pile that counts as solved, m/s. */
    private double settled;

    /** Whether every body of the packed island was found to be held where it is. */
    private boolean isHeld;

    /** Substeps that the packed island is given. */
    private int substeps;

    /**
     * A solver of what is declared, at an accuracy; {@code forces} change along the way, null where
     * there are none.
     */
    public PileSolver(
            DataStorage data,
            Narrowphase narrowphase,
            Effects effects,
            Accuracy accuracy,
            PileForces forces) {
        bodies = data.bodies;
        motions = new Motions(bodies.turns());
        islands = data.islands;
        counters = data.counters;
        this.accuracy = accuracy;
        isCorrecting = accuracy.correction() == Correction.SOFT;
        isDirect = accuracy.contactSolver() == ContactSolver.DIRECT;
        PackedTurns turns = bodies.turns() ? new PackedTurns(bodies, motions) : null;
        builder = new RowBuilder(data, motions, rows, turns);
        warmStart = new WarmStart(motions, rows);
        normals =
                new NormalSolver(
                        motions, rows, accuracy.contactSolver() != ContactSolver.SEQUENTIAL);
        overlap = new OverlapSolver(motions, rows);
        guard = new EnergyGuard(motions, rows, counters);
        halfway = new Halfway(motions, rows);
        direct = new DirectSolver(motions, rows, overlap, accuracy.substeps());
        split = new SplitSolver(motions, rows, overlap, accuracy.substeps());
        results = new PileResults(data, motions, rows, turns);
        boolean drags = effects.declares(Drag.class);
        DragKick drag = drags ? new DragKick(bodies, motions) : null;
        kick = new Kick(bodies, motions, forces, drag, turns);
        lateJoiners = new LateJoiners(bodies, motions, rows);
        repose =
                new Repose(
                        data,
                        motions,
                        rows,
                        isCorrecting ? overlap : null,
                        kick,
                        builder,
                        accuracy);
        FreshRows fresh = new FreshRows(data, narrowphase, motions, rows, builder);
        declared =
                new DeclaredRows(
                        data, effects, motions, rows, kick, fresh, accuracy.impactTolerance());
        passes = new Passes(motions, normals, declared, guard, accuracy);
    }

    /** Advances every island to the end of a step of {@code dt} seconds. */
    public void solve(double dt) {
        for (int island = 0; island < islands.count; island++) {
            if (repose.lasts(island, dt)) {
                results.goOn(island, dt);
                counters.solve(SolveMethod.AT_REST, 0);
                continue;
            }
            double start = lateJoiners.startOf(islands, island);
            if (dt > start) {
                substeps = declared.substepsFor(island, dt - start, accuracy.substeps());
                advance(island, start, (dt - start) / substeps, dt);
            }
        }
    }

    private void advance(int island, double start, double h, double dt) {
        builder.build(island, h / 2);
        declared.begin(h);
        warmStart.prepare();
        isRound = isRound();
        whole = isDirect ? wholeSolver(dt) : null;
        lateJoiners.delay(start, h);
        isHeld = false;
        boolean wasStill = repose.isStill(dt, share());
        SolveMethod method = whole == null ? SolveMethod.PASSES : whole.method();
        counters.solve(method, declared.rowCount() + rows.count);
        for (int substep = 0; substep < substeps; substep++) {
            double middle = start + (substep + 0.5) * h;
            kick.remember();
            double left = (substeps - substep) * h;
            if (declared.measureAnew(substep, h, dt - left, left) && whole != null) {
                whole.forget();
            }
            kick.accelerate(substep == 0 ? start : middle - h, middle);
            fastest = motions.fastest();
            setLimit(substep);
            begin(substep == 1 ? 2 : 1, substep);
            if (substep == 0 && wasStill && isCarried(start, h)) {
                rest();
                break;
            }
            if (whole != null) {
                settleSubstep(h, substep);
                if (substep == 0 && repose.isFound(start, h, substeps, settled)) {
                    rest();
                    break;
                }
                rows.addUpImpulses(1);
                motions.drift(h);
                takeOverlapBack(h, substep);
            } else {
                passes.advance(h, substep, isRound, limit);
            }
        }
        if (isHeld) {
            finishHeld();
        } else {
            finish(h, dt);
        }
        results.store(h, dt - start);
        declared.store(h);
    }

    /**
     * Lets contacts carry in all other substeps what they carried in the first. Nobody moves: what
     * is left of their speeds is what counts as none.
     */
    private void rest() {
        rows.addUpImpulses(2 * substeps - 1);
        substeps = 1;
    }

    /**
     * An island whose bodies move less than a falling one gains in a step counts as calm. Without
     * friction, or of discs, nothing is stacked wide: what is poured is left to passes, which are
     * faster.
     */
    private WholeSolver wholeSolver(double dt) {
        if (direct.prepare()) {
            return direct;
        }
        if (declared.rowCount() == 0 || isRound) {
            return null;
        }
        boolean isCalm = motions.fastest() <= CALM * dt * kick.strongest();
        return split.prepare(isCalm) ? split : null;
    }

    private boolean isRound() {
        int angular = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            boolean isDisc = bodies.shape[motions.slots[entry]].kind() == ShapeKind.CIRCLE;
            angular += isDisc ? 0 : 1;
        }
        return angular < LEAST_ANGULAR * motions.count;
    }

    private void begin(double scale, int substep) {
        if (whole != null) {
            guard.begin();
        }
        if (whole != null && rows.strongestAnswer() > MOST_STRESS * fastest) {
            rows.unload();
        }
        if (whole != null && substep > 0) {
            warmStart.leaveOutBlows();
        }
        if (whole != null) {
            warmStart.scaleBefore(scale, substep);
        }
        warmStart.apply(scale, substep);
        // What contacts carried throws bodies about if what they carried it against is gone.
        guard.limitSpeed(leverage() * fastest);
        if (whole != null) {
            double turn = MOST_TURN / substeps;
            guard.limitWork(turn * turn);
        }
    }

    /** A large pile may also part as fast as overlap is taken back. */
    private void setLimit(int substep) {
        if (substep == 0) {
            double parting = whole != null ? 0 : OverlapSolver.MOST_PUSH * rows.widest();
            limit = Math.max(leverage() * fastest, parting);
        } else if (whole != null) {
            limit = Math.max(limit, fastest);
        }
    }

    /** A large pile is never solved to the end: only what would blow it up is held back there. */
    private double leverage() {
        return whole != null ? MOST_LEVERAGE : MOST_LEVERAGE_IF_LARGE;
    }

    private void settleSubstep(double h, int substep) {
        whole.begin();
        declared.strikeJointly(h, substep);
        settle(h, substep);
    }

    /** Share of the fastest speed that counts as solved. */
    private double share() {
        double finest = whole == null ? SplitSolver.FINEST : whole.finestShare();
        return Math.max(SETTLED * accuracy.impactTolerance(), finest);
    }

    private boolean isCarried(double start, double h) {
        settled = share() * fastest;
        isHeld = repose.isCarried(start, h, substeps, settled, fastest);
        return isHeld;
    }

    private void takeOverlapBack(double h, int substep) {
        if (isCorrecting) {
            whole.correct(h, substep, fastest);
            overlap.correct(h, substep);
        }
    }

    /** Goes on until a small pile is solved, which at rest it is after the first round. */
    private void settle(double h, int substep) {
        boolean isSettled = settleRows(h, substep);
        guard.limitEnergy();
        if (!isSettled) {
            guard.limitSpeed(limit);
        }
    }

    private boolean settleRows(double h, int substep) {
        settled = share() * fastest;
        double before = Double.POSITIVE_INFINITY;
        for (int i = 0; i < LEAST_ROUNDS + accuracy.substeps(); i++) {
            double change = declared.rub(substep);
            change = Math.max(change, normals.back(h, substep));
            settled = Math.max(settled, ROUND_OFF * rows.strongestAnswer());
            boolean isStuck = whole == split && change > SHRINKS * before;
            if (change <= settled || isStuck) {
                return true;
            }
            halfway.begin();
            whole.solve(h, substep, settled, fastest);
            if (whole.isSpent()) {
                break;
            }
            if (change > SHRINKS * before) {
                halfway.end();
            }
            before = change;
        }
        declared.rub(substep);
        normals.forth(h, substep);
        return false;
    }

    /** What held the first half of a kick holds its second half as well: nothing moves at all. */
    private void finishHeld() {
        motions.halt();
        rows.addUpImpulses(1);
    }

    /**
     * The second half of the last kick: velocities are those at the end of the step. Nothing moves
     * any more, so in a small pile a gap that would close in the next step is no reason to slow
     * down in this one. A large pile is never solved so well: there that reason keeps it calm.
     */
    private void finish(double h, double dt) {
        int last = substeps;
        boolean isChanged = declared.measureAnew(last, 0, dt, 0);
        if (whole != null) {
            if (isChanged) {
                whole.forget();
            }
            closeLoadedGaps();
        }
        kick.accelerate(dt - h / 2, dt);
        fastest = motions.fastest();
        begin(last == 1 ? 1 : 0.5, last);
        if (whole != null) {
            declared.strikeAtOnce(h * NO_TIME, last);
            settle(h * NO_TIME, last);
            rows.addUpImpulses(1);
        } else {
            passes.hold(h, last, isRound, limit);
        }
    }

    /**
     * What carried a load in the last substep touches still, however little a corner has left its
     * line since: it must not fall for half a kick.
     */
    private void closeLoadedGaps() {
        double[] d = rows.data;
        for (int row = 0; row < rows.count; row++) {
            int at = row * Rows.STRIDE;
            double touching = PairTolerances.TOUCHING_GAP * d[at + Rows.WIDTH];
            for (int point = 0; point < rows.points[row]; point++) {
                double gap = motions.gap(rows, row, point);
                if (d[at + Rows.IMPULSE0 + point] > 0 && gap > 0 && gap < touching) {
                    d[at + Rows.GAP0 + point] -= gap;
                }
            }
        }
    }
}
