package rigibo.backend.contact;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.contact.joint.JointSolver;
import rigibo.backend.contact.joint.Stages;
import rigibo.backend.contact.row.CarriedFrame;
import rigibo.backend.contact.row.DragKick;
import rigibo.backend.contact.row.FreshRows;
import rigibo.backend.contact.row.IslandForces;
import rigibo.backend.contact.row.IslandResults;
import rigibo.backend.contact.row.KeptContacts;
import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.LateJoiners;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedTurns;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.contact.row.SharedRows;
import rigibo.backend.contact.row.Straightness;
import rigibo.backend.contact.row.WarmStart;
import rigibo.backend.contact.solve.OverlapSolver;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.Correction;
import rigibo.backend.setup.SolveMethod;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.IslandWork;
import rigibo.backend.storage.Islands;

/**
 * Advances islands with joints or locked axes by one step, one after the other. A joined body is
 * part of an island from the start of the step, whether it touches anything or not.
 */
final class JointedIslands {

    /** Factor by which the substeps may be too few after a joint became taut within the step. */
    private static final double MORE = 1.5;

    /** How often a step with too few substeps is made again. */
    private static final int MOST_AGAIN = 3;

    /** Number of substeps for fast islands that are too taut, as a multiple of the usual one. */
    private static final int MORE_IF_TAUT = 2;

    private final Accuracy accuracy;
    private final Motions motions;
    private final PackedContacts contacts = new PackedContacts();
    private final RowBuilder builder;
    private final WarmStart warmStart;
    private final OverlapSolver overlap;
    private final LateJoiners lateJoiners;
    private final KeptContacts kept;
    private final DeclaredRows declared;
    private final IslandResults results;
    private final JointSolver joints;
    private final Islands islands;
    private final Stages stages;
    private final JointedKicks kicks;
    private final JointedParts parts;
    private final Kick kick;
    private final Substeps fewer;
    private final CarriedFrame frame;
    private final JointedRepose repose;

    JointedIslands(
            DataStorage data,
            Narrowphase narrowphase,
            Effects effects,
            Accuracy accuracy,
            IslandForces forces) {
        this.accuracy = accuracy;
        motions = new Motions(data.bodies.turns());
        PackedTurns turns = motions.turns ? new PackedTurns(data.bodies, motions) : null;
        builder = new RowBuilder(data, motions, contacts, turns);
        warmStart = new WarmStart(motions, contacts);
        results = new IslandResults(data, motions, contacts, turns);
        boolean drags = effects.declares(Drag.class);
        DragKick drag = drags ? new DragKick(data.bodies, motions) : null;
        kick = new Kick(data.bodies, motions, forces, drag, turns);
        lateJoiners = new LateJoiners(data.bodies, motions, contacts);
        kept = new KeptContacts(data, contacts);
        overlap = new OverlapSolver(data.bodies, motions, contacts, accuracy);
        boolean isCorrecting = accuracy.correction() == Correction.SOFT;
        Straightness straight = new Straightness(motions, accuracy);
        SharedRows alone = new SharedRows(null, contacts);
        FreshRows fresh = new FreshRows(data, narrowphase, motions, contacts, builder, alone);
        declared = new DeclaredRows(data, effects, motions, contacts, kick, fresh, straight, alone);
        joints = new JointSolver(data, motions, contacts, builder, fresh, accuracy);
        islands = data.islands;
        fewer = new Substeps(data);
        frame = new CarriedFrame(data, motions);
        repose = new JointedRepose(data, motions, kick, builder, results, accuracy);
        stages = new Stages(data.bodies, motions, accuracy);
        OverlapSolver wanted = isCorrecting ? overlap : null;
        kicks =
                new JointedKicks(
                        motions, contacts, data.pairs, kick, warmStart, wanted, joints, stages);
        parts = new JointedParts(joints, kicks, stages, declared);
    }

    /** Advances an island to the end of a step of {@code dt} seconds. */
    void solve(int island, double dt) {
        frame.enter(island);
        boolean lasts = repose.lasts(island, dt);
        if (lasts) {
            repose.goOn(island, dt);
            contacts.work.solve(SolveMethod.AT_REST, 0);
        } else {
            advanceAndStore(island, dt);
        }
        frame.leave(island, dt);
        if (!lasts) {
            results.quarantine();
        }
    }

    private void advanceAndStore(int island, double dt) {
        int substeps = substepsFor(island, dt, 0, 0);
        kept.keep(island);
        for (int again = 0; ; again++) {
            boolean wasTaut = joints.needed.isTaut();
            advance(island, dt, substeps);
            joints.tellGreatest(dt);
            int wanted = substepsFor(island, dt, parts.finest(), contacts.totalImpulse() / dt);
            boolean isNewlyTaut = joints.needed.isTautFor(substeps) && !wasTaut;
            if (again == MOST_AGAIN || wanted <= MORE * substeps && !isNewlyTaut) {
                break;
            }
            // An island that became taut within the step oscillates faster than its substeps
            // resolve; the tension that they found may be wrong, too.
            substeps = wanted;
            lateJoiners.restoreTimes();
            kept.restore(island);
        }
        joints.tell(dt);
        contacts.work.multiplications += joints.multiplications();
        contacts.work.contactSolves += joints.rowSolves();
        contacts.work.solve(joints.method(), declared.rowCount() + contacts.count);
        results.store(2 * kicks.kicked(), dt);
        declared.store(2 * kicks.kicked());
        joints.store(kicks.kicked());
    }

    private int substepsFor(int island, double dt, double finest, double contactForce) {
        boolean areMany = joints.areCrowd(island, dt);
        int most = accuracy.substeps();
        int usual =
                areMany
                        ? fewer.byWay(island, dt, most)
                        : joints.needed.of(island, dt, most, finest, contactForce);
        boolean isStill = !areMany && joints.needed.standsStill();
        int needed = isStill ? fewer.byWay(island, dt, MORE_IF_TAUT * most) : usual;
        return declared.substepsFor(island, dt, needed);
    }

    /**
     * Packs an island and returns its number of substeps: the usual one, more if springs are fast,
     * or fewer if eliminating all of its rows is too much work.
     */
    private int pack(int island, double dt, int usual) {
        packFor(island, dt / usual / 2, usual);
        boolean isWhole = joints.isWhole();
        int slow = isWhole ? usual : fewer.byWay(island, dt, accuracy.substeps());
        int fewest = Math.min(usual, declared.substepsFor(island, dt, slow));
        int substeps = isWhole ? joints.needed.forSprings(dt, fewest) : fewest;
        if (substeps != usual) {
            packFor(island, dt / substeps / 2, substeps);
        }
        return substeps;
    }

    private void packFor(int island, double firstKick, int substeps) {
        builder.build(island, firstKick);
        joints.pack(island, firstKick, substeps);
        motions.areFollowed = joints.areImpactsTimed();
    }

    /**
     * Number of substeps for the packed island if they are not composed; all of them if it is fast.
     */
    private int plainSubsteps(int island, double dt, int packed) {
        int byWay = declared.areAnyContacts() ? fewer.byWay(island, dt, packed) : 1;
        return joints.needed.plain(island, dt, byWay, packed);
    }

    /** Advances an island from its stored state, without storing the result. */
    private void advance(int island, double dt, int usual) {
        int packed = pack(island, dt, usual);
        int substeps = plainSubsteps(island, dt, packed);
        // A composed substep has a stage back in time, in which drag would accelerate bodies.
        boolean isFree = stages.mayCompose() && !kick.isForced() && !joints.needed.isTaut();
        boolean mayCompose =
                substeps == packed && isFree && joints.areHeldByEquations(2 * dt / packed);
        if (mayCompose) {
            // Half as many substeps of the fourth order are more accurate and cost little more. But
            // contacts are measured once per substep, and bodies held only by locks turn about
            // them.
            boolean isTurning = declared.areAnyContacts() && !islands.areJoined(island);
            int most = isTurning ? packed : (packed + 1) / 2;
            substeps = joints.needed.composed(island, dt, most);
            stages.beginComposed();
        } else {
            stages.begin();
            joints.beginSubsteps(dt / substeps);
        }
        double h = dt / substeps;
        double packedKick = dt / packed / 2;
        declared.begin(h, packedKick, 0);
        declared.foresee(dt);
        warmStart.prepare();
        overlap.prepareJointed();
        lateJoiners.delayToSubsteps(h);
        kicks.begin(packedKick);
        parts.begin(dt / (2 * ((packed + 1) / 2)));
        for (int substep = 0; substep < substeps; substep++) {
            parts.advance(substep * h, h, substep, dt, mayCompose);
        }
        parts.finish(dt, h, substeps);
    }

    /** Work counters of the islands since the last call. */
    IslandWork work() {
        return contacts.work;
    }
}
