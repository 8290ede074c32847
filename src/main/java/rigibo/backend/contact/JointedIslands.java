package rigibo.backend.contact;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.contact.joint.JointSolver;
import rigibo.backend.contact.joint.Stages;
import rigibo.backend.contact.row.DragKick;
import rigibo.backend.contact.row.FreshRows;
import rigibo.backend.contact.row.IslandForces;
import rigibo.backend.contact.row.IslandResults;
import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.LateJoiners;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedTurns;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.contact.row.Straightness;
import rigibo.backend.contact.row.WarmStart;
import rigibo.backend.contact.solve.OverlapSolver;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.Correction;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.IslandWork;

/**
 * Advances islands with joints by one step, one after the other. A joined body is part of an island
 * from the step's start on, whether it touches anything or not.
 */
final class JointedIslands {

    /** Share of a substep that counts as an instant, but lets a gap of round-off stay open. */
    private static final double NO_TIME = 1e-3;

    /** Factor by which substeps may be too few for what became taut within the step. */
    private static final double MORE = 1.5;

    /** Passes in which overlap is taken back in a substep; the next one goes on. */
    private static final int PASSES_OVER_OVERLAP = 6;

    private final Accuracy accuracy;
    private final Motions motions;
    private final PackedContacts contacts = new PackedContacts();
    private final RowBuilder builder;
    private final Kick kick;
    private final WarmStart warmStart;
    private final OverlapSolver overlap;
    private final LateJoiners lateJoiners;
    private final DeclaredRows declared;
    private final IslandResults results;
    private final JointSolver joints;
    private final Stages stages;
    private final boolean isCorrecting;

    /** When the last kick ended, s after the step's start, and how long it was, s. */
    private double middle;

    private double kicked;

    /** How long the last part of the step was, s; 0 where there was none. */
    private double last;

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
        overlap = new OverlapSolver(data.bodies, motions, contacts, accuracy);
        isCorrecting = accuracy.correction() == Correction.SOFT;
        Straightness straight = new Straightness(motions, accuracy);
        FreshRows fresh = new FreshRows(data, narrowphase, motions, contacts, builder);
        declared = new DeclaredRows(data, effects, motions, contacts, kick, fresh, straight);
        joints = new JointSolver(data, motions, contacts, builder, accuracy);
        stages = new Stages(data.bodies, motions, forces == null && !drags, accuracy);
    }

    /** Advances an island to the end of a step of {@code dt} seconds. */
    void solve(int island, double dt) {
        int substeps = substepsFor(island, dt);
        advance(island, dt, substeps);
        joints.tell(dt);
        int wanted = substepsFor(island, dt);
        if (wanted > MORE * substeps) {
            // What became taut within the step trembles faster than its substeps can follow.
            advance(island, dt, wanted);
            joints.tell(dt);
        }
        contacts.work.multiplications += joints.multiplications();
        contacts.work.contactSolves += joints.rowSolves();
        contacts.work.solve(joints.method(), declared.rowCount() + contacts.count);
        results.store(2 * kicked, dt);
        declared.store(2 * kicked);
        joints.store(kicked);
        results.quarantine();
    }

    private int substepsFor(int island, double dt) {
        int usual = joints.substepsFor(island, dt, accuracy.substeps());
        return declared.substepsFor(island, dt, usual);
    }

    /** Advances an island as it is stored, without storing what it comes to. */
    private void advance(int island, double dt, int usual) {
        int substeps = usual;
        double h = dt / substeps;
        builder.build(island, h / 2);
        joints.pack(island, h / 2, substeps);
        declared.begin(h, 0);
        declared.foresee(dt);
        warmStart.prepare();
        overlap.prepare();
        lateJoiners.delay(0, h);
        if (contacts.count == 0 && joints.areHeldByEquations(2 * h, dt)) {
            // Half as many of the fourth order are worth more, and cost little more.
            substeps = stages.beginComposed(substeps);
            h = dt / substeps;
        } else {
            stages.begin();
        }
        middle = 0;
        kicked = h / 2;
        last = 0;
        for (int substep = 0; substep < substeps; substep++) {
            double time = substep * h;
            measure(substep, time, dt - time, h);
            for (int i = 0; i < stages.count(); i++) {
                advance(time, stages.length(i, h), substep);
                time += stages.length(i, h);
            }
        }
        measure(substeps, dt, 0, 0);
        finish(dt, h, substeps);
    }

    /** What its islands took since that was asked for last. */
    IslandWork work() {
        return contacts.work;
    }

    private void measure(int substep, double time, double left, double h) {
        if (contacts.count > 0) {
            declared.measureAnew(substep, true, time, left);
            declared.bend(h, h);
        }
    }

    /** A part of a substep, of h seconds, which may go back in time. */
    private void advance(double time, double h, int substep) {
        double length = (last + h) / 2;
        joints.write(length, h);
        accelerate(time + h / 2);
        double fastest = motions.fastest();
        warmStart.apply(length / kicked, substep);
        kicked = length;
        joints.solve(h, substep, fastest);
        contacts.addUpImpulses(1);
        motions.drift(h);
        if (isCorrecting) {
            if (contacts.count > 0) {
                overlap.correctInPasses(h, substep, PASSES_OVER_OVERLAP);
            }
            joints.correct(h);
        }
        last = h;
    }

    private void accelerate(double until) {
        kick.remember();
        if (stages.areComposed()) {
            stages.accelerate(until - middle);
        } else {
            kick.accelerate(middle, until);
        }
        middle = until;
    }

    /** The second half of the last kick, after which velocities are those of the step's end. */
    private void finish(double dt, double h, int substep) {
        double length = last / 2;
        joints.write(length, last);
        accelerate(dt);
        double fastest = motions.fastest();
        warmStart.apply(length / kicked, substep);
        kicked = length;
        joints.solveAtRest(NO_TIME * h, substep, fastest);
        contacts.addUpImpulses(1);
    }
}
