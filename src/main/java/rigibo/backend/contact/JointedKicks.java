package rigibo.backend.contact;

import rigibo.backend.contact.joint.JointSolver;
import rigibo.backend.contact.joint.Stages;
import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.LockedAxes;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.WarmStart;
import rigibo.backend.contact.solve.OverlapSolver;
import rigibo.backend.storage.Pairs;

/**
 * Kicks and drifts of an island with joints. Between two kicks velocities are those at the middle
 * of a part; after the second half of a kick they are those at the present time.
 */
final class JointedKicks {

    /**
     * Share of a substep that stands for no time. It is not 0, so that the speed at which a gap of
     * round-off may close, gap over time, stays negligible.
     */
    private static final double NO_TIME = 1e-3;

    /** Passes over overlap in a substep; the next substep continues. */
    private static final int PASSES_OVER_OVERLAP = 6;

    /**
     * Energy that contacts may add, as a share of the energy that a kick gives to bodies at rest.
     */
    private static final double NOISE = 0.1;

    private final Motions motions;
    private final PackedContacts contacts;
    private final Kick kick;
    private final WarmStart warmStart;
    private final JointSolver joints;
    private final Stages stages;
    private final JointedMoment moment;

    /** Locked axes; null if there are none. */
    private final LockedAxes locks;

    /** Removes overlap; null if overlap is not corrected. */
    private final OverlapSolver overlap;

    /** End of the last kick, s after the step's start. */
    private double middle;

    /** Length of the last kick, s. */
    private double kicked;

    /** Length of the last part, s; 0 if velocities are those at the present time. */
    private double last;

    /** Time that bodies have drifted since then without a kick, s. */
    private double slipped;

    /** Kept values of {@link #middle}, {@link #kicked}, {@link #last} and {@link #slipped}. */
    private double keptMiddle;

    private double keptKicked;
    private double keptLast;
    private double keptSlipped;

    JointedKicks(
            Motions motions,
            PackedContacts contacts,
            Pairs pairs,
            Kick kick,
            WarmStart warmStart,
            OverlapSolver overlap,
            JointSolver joints,
            Stages stages) {
        this.motions = motions;
        this.contacts = contacts;
        this.kick = kick;
        this.warmStart = warmStart;
        this.overlap = overlap;
        this.joints = joints;
        locks = joints.locks;
        this.stages = stages;
        moment = new JointedMoment(motions, contacts, pairs, joints);
    }

    /** Starts a step whose first kick would have a length in s. */
    void begin(double firstKick) {
        middle = 0;
        kicked = firstKick;
        last = 0;
        slipped = 0;
    }

    /** Length of the last kick, s. */
    double kicked() {
        return kicked;
    }

    /** Whether velocities are those at the present time. */
    boolean areVelocitiesOfNow() {
        return last == 0;
    }

    /** Keeps the present state, to be restored later. */
    void keep() {
        moment.keep();
        keptMiddle = middle;
        keptKicked = kicked;
        keptLast = last;
        keptSlipped = slipped;
    }

    /** Restores the state that was kept last. */
    void recall() {
        moment.recall();
        middle = keptMiddle;
        kicked = keptKicked;
        last = keptLast;
        slipped = keptSlipped;
    }

    /** Makes all stages of a part of h seconds that begins at a time, s. */
    void advance(double time, double h, int substep) {
        double now = time;
        for (int i = 0; i < stages.count(); i++) {
            advanceStage(now, stages.length(i, h), substep);
            now += stages.length(i, h);
        }
    }

    private void advanceStage(double time, double h, int substep) {
        double length = (last + h) / 2 + slipped;
        joints.write(length, h);
        joints.begin(h);
        accelerate(time + h / 2);
        joints.takeFree();
        double fastest = motions.fastest();
        applyWarmStart(length, substep);
        kicked = length;
        joints.solve(h, substep, fastest, NOISE * kick.energy(h));
        contacts.addUpImpulses(1);
        motions.drift(h);
        if (overlap != null) {
            if (contacts.count > 0 && !stages.areComposed()) {
                takeOverlapBack(h, substep);
            }
            joints.correct(h);
        }
        last = h;
        slipped = 0;
    }

    private void takeOverlapBack(double h, int substep) {
        if (joints.takesOverlapBack()) {
            joints.takeOverlapBack(h);
        } else if (locks != null && locks.areAny()) {
            joints.lockedOverlap.correct(h, PASSES_OVER_OVERLAP);
        } else {
            overlap.correctInPasses(h, substep, PASSES_OVER_OVERLAP);
        }
    }

    /** Warm starts contacts with a share of their impulses in the kick before. */
    private void applyWarmStart(double length, int substep) {
        warmStart.apply(length / kicked, substep);
        if (locks != null) {
            locks.hold();
        }
    }

    private void accelerate(double until) {
        kick.remember();
        if (stages.areComposed()) {
            // The kick may go back in time. No body joins in it, but a force may begin to act.
            kick.refresh(middle, until);
            stages.accelerate(middle, until);
        } else {
            kick.accelerate(middle, until);
        }
        if (locks != null) {
            locks.hold();
        }
        middle = until;
    }

    /** Lets bodies drift at their velocities for a time (s) that is too short for a kick. */
    void slip(double length) {
        motions.drift(length);
        slipped += length;
    }

    /**
     * Makes the second half of the last kick, up to a time in s, after which velocities are those
     * at the present time; substeps are h seconds long.
     */
    void end(double time, double h, int substep) {
        double length = last / 2 + slipped;
        if (length == 0) {
            return;
        }
        joints.writeAtRest(length, h);
        joints.begin(h);
        accelerate(time);
        joints.takeFree();
        double fastest = motions.fastest();
        applyWarmStart(length, substep);
        kicked = length;
        joints.solveAtRest(NO_TIME * h, substep, fastest, NOISE * kick.energy(h));
        contacts.addUpImpulses(1);
        last = 0;
        slipped = 0;
    }
}
