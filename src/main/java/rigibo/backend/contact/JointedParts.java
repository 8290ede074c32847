package rigibo.backend.contact;

import rigibo.backend.contact.joint.JointSolver;
import rigibo.backend.contact.joint.Stages;
import rigibo.backend.contact.joint.Strikes;

/**
 * Advances an island with joints by a substep, in parts. A part ends where a stop is reached fast
 * (a limit, the end of a rope, another body); the impact is resolved there, at the velocities of
 * that instant, and the next part begins anew. Where equations and stops that are open or pressed
 * alone hold an island, a part is composed of several stages.
 */
final class JointedParts {

    /** Parts of a substep that end before it does; then stops are solved as they are reached. */
    private static final int MOST_ENDED = 48;

    /** Times that the end of a part is looked for. */
    private static final int MOST_LOOKS = 12;

    /** Share of a substep that is too short for a kick of its own. */
    private static final double INSTANT = 1e-5;

    /** Share of a substep that is round-off. */
    private static final double NOTHING = 1e-12;

    /** Of a part that cannot be composed. */
    private static final double NOT_COMPOSED = -1;

    private final JointSolver joints;
    private final Strikes strikes;
    private final JointedKicks kicks;
    private final Stages stages;
    private final DeclaredRows declared;

    /** The substep: its length in s, its number, and how long the step is, s. */
    private double h;

    private int substep;
    private double dt;

    /** How long a part of a substep is that was to be composed and cannot be, s. */
    private double plain;

    /** Parts of the substep that ended early, and how many may. */
    private int ended;

    private int most;

    /** Whether impacts of an instant had no end: in the rest of the step stops are solved. */
    private boolean isWedged;

    /** Whether bodies lie on something, which does not end until something is struck. */
    private boolean isOnStops;

    JointedParts(JointSolver joints, JointedKicks kicks, Stages stages, DeclaredRows declared) {
        this.joints = joints;
        this.kicks = kicks;
        this.stages = stages;
        this.declared = declared;
        strikes = joints.strikes;
    }

    /** Begins a step in which parts that are not composed are so many seconds long. */
    void begin(double plainPart) {
        plain = plainPart;
        isOnStops = false;
        isWedged = false;
    }

    /**
     * Advances a substep of {@code length} seconds that begins at a time, of a step of {@code step}
     * seconds. A composed one is made in shorter parts where it cannot be composed.
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
            double part = mayCompose ? Math.min(left, plain) : left;
            declared.measureJointed(substep, done == 0, time, dt - time, part);
            boolean composes = mayCompose && !isOnStops && declared.haveAllJoined(substep);
            double gone = composes ? advanceComposed(time, left) : NOT_COMPOSED;
            if (gone == NOT_COMPOSED) {
                gone = advancePlainly(time, part);
            }
            done += gone;
        }
    }

    private double advanceComposed(double time, double left) {
        if (ended >= most || !joints.isWhole()) {
            return NOT_COMPOSED;
        }
        stages.beginComposed();
        if (joints.haveStops()) {
            find(left, true);
            if (strikes.areAnyNow()) {
                strikeNow(time);
                return 0;
            }
            if (!strikes.mayBeComposed()) {
                isOnStops = declared.areAnyContacts();
                return NOT_COMPOSED;
            }
        }
        return follow(time, left, true);
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

    /** Strikes what is on its stop already. */
    private void strikeNow(double time) {
        isOnStops = false;
        boolean wereOfNow = kicks.areVelocitiesOfNow();
        kicks.end(time, h, substep);
        boolean isAny = strike(time);
        // What could not be answered at velocities of now will not be when it is asked again.
        ended = isWedged || !isAny && wereOfNow ? most : ended + 1;
    }

    /** Strikes all that is on its stop; whether there was anything that had an end. */
    private boolean strike(double time) {
        kicks.keep();
        boolean isAny = joints.impacts.strike(time, substep);
        if (joints.impacts.areEndless()) {
            // Thrown to and fro in no time, bodies may have become faster than anything here.
            kicks.recall();
            isWedged = true;
        }
        return isAny && !isWedged;
    }

    /** Advances a part, up to where the first stop is reached; returns how far that is, s. */
    private double follow(double time, double part, boolean isComposed) {
        if (!strikes.areAny() && !isComposed) {
            kicks.advance(time, part, substep);
            return part;
        }
        kicks.keep();
        kicks.advance(time, part, substep);
        double first = strikes.first(part);
        while (strikes.areAnySoft() && !isComposed) {
            kicks.recall();
            kicks.advance(time, part, substep);
            first = strikes.first(part);
        }
        double gone = first == Strikes.NEVER ? part : reach(time, part, first);
        if (isComposed && (strikes.areAnySoft() || joints.isAnyPulled())) {
            kicks.recall();
            return NOT_COMPOSED;
        }
        if (first != Strikes.NEVER) {
            kicks.end(time + gone, h, substep);
            boolean isAny = strike(time + gone);
            // What could not be answered goes on closing, which stages back in time would feed.
            isOnStops = !isAny && declared.areAnyContacts();
            // What was reached before the part began, and slowly, would be found there again.
            ended = isWedged || !isAny && gone <= INSTANT * h ? most : ended + 1;
        }
        return gone;
    }

    /** Goes as far as the first stop; does nothing where that is no distance. */
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

    /** The end of the step, with substeps of so many seconds. */
    void finish(double step, double length, int substeps) {
        kicks.keep();
        kicks.end(step, length, substeps);
        if (joints.isAnyPulled()) {
            kicks.recall();
            strikes.watchNothing();
            kicks.end(step, length, substeps);
        }
    }
}
