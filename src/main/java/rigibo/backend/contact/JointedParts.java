package rigibo.backend.contact;

import rigibo.backend.contact.joint.JointSolver;
import rigibo.backend.contact.joint.JointSubsteps;
import rigibo.backend.contact.joint.Stages;
import rigibo.backend.contact.joint.Strikes;

/**
 * Advances an island with joints by a substep, in parts. A part ends at the time when a stop (a
 * limit, the end of a rope, another body) is reached fast; the impact is resolved at the velocities
 * of that time, and the next part begins. If an island is held only by equations and by stops that
 * stay open or stay pressed, a part is composed of several stages.
 */
final class JointedParts {

    /** Most parts of a substep that end early; after them stops are solved as they are reached. */
    private static final int MOST_ENDED = 48;

    /** Most parts of a substep that follow how fast bodies turn. */
    private static final double MOST_OF_TURNING = 64;

    /**
     * Factor on the allowed turning in a part above which it is made again in shorter ones: a kick
     * may have driven bodies far faster than they were.
     */
    private static final double TOO_FAST = 1.25;

    /** Most searches for the end of a part. */
    private static final int MOST_LOOKS = 12;

    /** Share of a substep that is too short for a separate kick. */
    private static final double INSTANT = 1e-5;

    /** Share of a substep that is round-off. */
    private static final double NOTHING = 1e-12;

    /** Result for a part that cannot be composed. */
    private static final double NOT_COMPOSED = -1;

    private final JointSolver joints;
    private final Strikes strikes;
    private final JointedKicks kicks;
    private final Stages stages;
    private final DeclaredRows declared;

    /** Length of the substep, s. */
    private double h;

    /** Number of the substep. */
    private int substep;

    /** Length of the step, s. */
    private double dt;

    /** Length of a part that was to be composed but cannot be, s. */
    private double plain;

    /** Number of parts that the step would need if it turned throughout as fast as at most. */
    private double finest;

    /** Number of parts of the substep that ended early. */
    private int ended;

    /** Most parts of the substep that may end early. */
    private int most;

    /** Whether simultaneous impacts did not end; then stops are solved for the rest of the step. */
    private boolean isWedged;

    /** Whether bodies lie on stops; that holds until an impact. */
    private boolean isOnStops;

    JointedParts(JointSolver joints, JointedKicks kicks, Stages stages, DeclaredRows declared) {
        this.joints = joints;
        this.kicks = kicks;
        this.stages = stages;
        this.declared = declared;
        strikes = joints.strikes;
    }

    /** Starts a step; parts that are not composed have the given length, s. */
    void begin(double plainPart) {
        plain = plainPart;
        isOnStops = false;
        isWedged = false;
        finest = 0;
    }

    /** Number of parts that the step would need if it turned throughout as fast as at most. */
    double finest() {
        return finest;
    }

    /**
     * Advances a substep of {@code length} seconds that begins at a time, in a step of {@code step}
     * seconds. If it should be composed but cannot be, it is made in shorter parts.
     */
    void advance(double start, double length, int number, double step, boolean mayCompose) {
        h = length;
        substep = number;
        dt = step;
        most = Math.min(MOST_ENDED, joints.mostStrikes());
        ended = isWedged ? most : 0;
        double done = 0;
        while (h - done > NOTHING * h) {
            double time = start + done;
            double left = h - done;
            if (left < INSTANT * h) {
                kicks.slip(left);
                return;
            }
            double rate = turning();
            double part = partOf(mayCompose ? Math.min(left, plain) : left, rate, 1);
            measure(time, done == 0, part);
            boolean composes = mayCompose && !isOnStops && declared.haveAllJoined(substep);
            double gone = composes ? advanceComposed(time, left, rate) : NOT_COMPOSED;
            if (gone == NOT_COMPOSED) {
                gone = advancePlainly(time, part);
            }
            done += gone;
        }
    }

    /** Measures contacts before a part of h seconds that begins at a time, s. */
    private void measure(double time, boolean isFirst, double h) {
        if (finest > 1 && time > 0) {
            declared.measureTurnedAbout(dt - time);
        }
        declared.measureJointed(substep, isFirst, time, dt - time, h);
    }

    /** How fast bodies turn about their joints at present, rad/s; 0 where nobody follows that. */
    private double turning() {
        double rate = joints.isWhole() ? joints.needed.turning() : 0;
        finest = Math.max(finest, JointSubsteps.parts(rate, dt));
        return rate;
    }

    /**
     * A part of h seconds, so short that nothing turns too far in it at a rate in rad/s, s; its
     * number is greater by a factor.
     */
    private static double partOf(double h, double rate, double finer) {
        double most = finer * JointSubsteps.parts(rate, h);
        return h / Math.max(1, Math.ceil(Math.min(MOST_OF_TURNING, most)));
    }

    private double advanceComposed(double time, double left, double rate) {
        if (ended >= most || !joints.isWhole()) {
            return NOT_COMPOSED;
        }
        double part = partOf(left, rate, joints.needed.finerIfComposed());
        stages.beginComposed();
        if (joints.haveStops()) {
            find(part, true);
            if (strikes.areAnyNow()) {
                strikeNow(time);
                return 0;
            }
            if (!strikes.mayBeComposed()) {
                isOnStops = declared.areAnyContacts();
                return NOT_COMPOSED;
            }
        }
        return follow(time, part, true);
    }

    private double advancePlainly(double time, double part) {
        stages.begin();
        if (joints.haveStops()) {
            if (ended < most && joints.isWhole()) {
                find(part, false);
                if (strikes.areAnyNow()) {
                    strikeNow(time);
                    return 0;
                }
            } else {
                strikes.watchNothing();
            }
        }
        return follow(time, part, false);
    }

    private void find(double part, boolean isComposed) {
        boolean areOfNow = kicks.areVelocitiesOfNow();
        joints.findStrikes(part, kicks.kicked(), substep, areOfNow, isComposed);
    }

    /** Resolves impacts of bodies that are already on their stops. */
    private void strikeNow(double time) {
        isOnStops = false;
        boolean wereOfNow = kicks.areVelocitiesOfNow();
        kicks.end(time, h, substep);
        boolean isAny = strike(time);
        // Impacts without a solution at the present velocities would not get one by a retry.
        ended = isWedged || !isAny && wereOfNow ? most : ended + 1;
    }

    /** Resolves all impacts on stops; returns whether there were any and they ended. */
    private boolean strike(double time) {
        kicks.keep();
        boolean isAny = joints.impacts.strike(time, substep);
        if (joints.impacts.areEndless()) {
            // Bodies thrown to and fro in no time may have become faster than any body before.
            kicks.recall();
            isWedged = true;
        }
        return isAny && !isWedged;
    }

    /** Advances a part up to the time when the first stop is reached; returns its length, s. */
    private double follow(double time, double wanted, boolean isComposed) {
        kicks.keep();
        kicks.advance(time, wanted, substep);
        double part = notTooFast(time, wanted, isComposed);
        if (!strikes.areAny() && !isComposed) {
            return part;
        }
        double first = strikes.first(part, dt - time - part);
        while (strikes.areAnySoft() && !isComposed) {
            kicks.recall();
            kicks.advance(time, part, substep);
            first = strikes.first(part, dt - time - part);
        }
        double gone = first == Strikes.NEVER ? part : reach(time, part, first);
        if (isComposed && (strikes.areAnySoft() || joints.isAnyPulled())) {
            kicks.recall();
            return NOT_COMPOSED;
        }
        if (first != Strikes.NEVER) {
            kicks.end(time + gone, h, substep);
            boolean isAny = strike(time + gone);
            // Unsolved impacts go on closing; stages back in time would add to that.
            isOnStops = !isAny && declared.areAnyContacts();
            // A stop that was reached slowly before the part began would be found there again.
            ended = isWedged || !isAny && gone <= INSTANT * h ? most : ended + 1;
        }
        return gone;
    }

    /**
     * Makes a part of {@code wanted} seconds again in a shorter time if its kick made bodies turn
     * too fast for it; returns its length, s.
     */
    private double notTooFast(double time, double wanted, boolean isComposed) {
        double rate = turning();
        double finer = isComposed ? joints.needed.finerIfComposed() : 1;
        double part = Math.max(h / MOST_OF_TURNING, partOf(wanted, rate, finer));
        boolean isTooFast = finer * JointSubsteps.parts(rate, wanted) > TOO_FAST;
        if (!isTooFast || part >= wanted) {
            return wanted;
        }
        kicks.recall();
        kicks.advance(time, part, substep);
        return part;
    }

    /** Advances up to the first stop; returns the length of the part, s. */
    private double reach(double time, double part, double first) {
        double to = first;
        for (int look = 0; look < MOST_LOOKS; look++) {
            kicks.recall();
            if (to < INSTANT * h) {
                kicks.end(time, h, substep);
                kicks.slip(to);
                return to;
            }
            kicks.advance(time, to, substep);
            double until = strikes.untilFirst(dt - time - to);
            double next = Math.max(0, Math.min(part, to + until));
            if (until == 0 || next == to) {
                return to;
            }
            if (look + 1 < MOST_LOOKS) {
                to = next;
            }
        }
        return to;
    }

    /** Ends the step; substeps have the given length, s. */
    void finish(double step, double length, int substeps) {
        substep = substeps;
        measure(step, true, 0);
        kicks.keep();
        kicks.end(step, length, substeps);
        if (joints.isAnyPulled()) {
            kicks.recall();
            strikes.watchNothing();
            kicks.end(step, length, substeps);
        }
    }
}
