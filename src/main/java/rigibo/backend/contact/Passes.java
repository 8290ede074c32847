package rigibo.backend.contact;

import rigibo.backend.contact.row.EarlierImpulses;
import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.solve.ContactSweep;
import rigibo.backend.contact.solve.EnergyGuard;
import rigibo.backend.contact.solve.OverlapSolver;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.Correction;

/**
 * Advances an island that moves, substep by substep, by passes over its contacts. Where bodies
 * overlap they are moved apart, which gives them no speed.
 */
public final class Passes {

    /**
     * Share of the island's fastest speed below which a change is neglected; less where substeps
     * are longer than the game's, for a kick adds more in them.
     */
    private static final double QUIET = 0.03;

    /**
     * The same in a crowd that falls or is struck: {@link ContactSweep} solves what sinks in
     * strictly whatever this share is. A crowd that slows down is given less and less of it, for it
     * would never come to rest with all of it.
     */
    private static final double QUIET_IN_A_CROWD = 0.1;

    /** Share of what a free body gains in a step below which a crowd gets half of the passes. */
    private static final double CALM = 0.25;

    /**
     * Speed that does not count in a large crowd, as a share of what a free body gains in a step,
     * times what may be missed in widths: a sixth of a millimetre a second at the game's accuracy.
     * What lies still is then asked little, and comes nearer to rest all the same.
     */
    private static final double UNSEEN = 1;

    /** A crowd of more contacts than these counts as large. */
    private static final int LARGE = 512;

    /** What does not count where a crowd lies still, as a share of what does not count for all. */
    private static final double OF_THE_FASTEST = 0.05;

    /**
     * Cubed number of substeps for each pass that a substep is given at most: twice the substeps
     * halve the threshold about five times, and each halving takes as many passes again.
     */
    private static final int CUBES_PER_PASS = 2;

    private static final int LEAST_PASSES = 16;

    /** How many times farther a contact of a crowd may miss its bounds than one of a few. */
    private static final double MISSED_IN_A_CROWD = 3;

    /**
     * How many times what may be missed a contact of a crowd may sink in before passes go on: an
     * impact that many bodies pass on to the ground is not answered by the usual ones.
     */
    private static final double SUNK = 2;

    /** How many times the passes are made anew for the sake of that. */
    private static final int LONGER = 7;

    /** Contacts that these solve in a substep at most: no crowd's worst step is to take longer. */
    private static final int MOST_SOLVES = 80_000;

    /**
     * Contacts of few that are solved in a substep at most for the sake of what sinks in: a bullet
     * of a thousand times the mass of what it presses against a wall.
     */
    private static final int MOST_SOLVES_OF_FEW = 400_000;

    /**
     * As many as the finest accuracy that has a name is given; what asks for more gains nothing.
     */
    private static final int MOST_PASSES = 2048;

    /** Passes in which overlap is taken back in a substep; the next one goes on. */
    private static final int PASSES_OVER_OVERLAP = 6;

    /**
     * Energy that the contacts of a substep may add, as a share of what a kick of the game's length
     * gives to bodies at rest.
     */
    private static final double NOISE = 0.1;

    private final Motions motions;
    private final PackedContacts contacts;
    private final DeclaredRows declared;
    private final EarlierImpulses earlier;
    private final Kick kick;
    private final EnergyGuard guard;
    private final ContactSweep sweep;
    private final OverlapSolver overlap;

    /**
     * How far a contact may miss its bounds in a substep, in widths: the tolerance of impacts to
     * the power of three quarters, a thousandth at the game's accuracy. Finer accuracies ask for
     * less, but each pass only removes a share of the error, not a digit.
     */
    private final double missed;

    /** How many substeps a step has for each of the game's, at most 1. */
    private final double shorter;

    /** How many times passes are made anew; at a draft's accuracy what sinks in does. */
    private final int longer;

    private final double noise;
    private final boolean isCorrecting;
    private final int most;
    private final int usual;

    /** Passes that a calm crowd is given in a substep at most. */
    private int mostIfCalm;

    /** Passes that an island of few contacts is given: the more the more its masses differ. */
    private int mostOfFew;

    /** Length of the step, s. */
    private double step;

    public Passes(
            Motions motions,
            PackedContacts contacts,
            DeclaredRows declared,
            Kick kick,
            EnergyGuard guard,
            ContactSweep sweep,
            OverlapSolver overlap,
            Accuracy accuracy) {
        this.motions = motions;
        this.contacts = contacts;
        this.declared = declared;
        earlier = new EarlierImpulses(contacts);
        this.kick = kick;
        this.guard = guard;
        this.sweep = sweep;
        this.overlap = overlap;
        missed = missed(accuracy);
        isCorrecting = accuracy.correction() == Correction.SOFT;
        usual = accuracy.substeps();
        shorter = Math.min(1, usual / (double) Accuracy.GAME.substeps());
        longer = usual < Accuracy.GAME.substeps() ? 0 : LONGER;
        noise = NOISE * shorter * shorter;
        int passes = Math.max(LEAST_PASSES, usual * usual * usual / CUBES_PER_PASS);
        most = Math.min(MOST_PASSES, accuracy.velocityIterations() * passes);
    }

    /**
     * What a contact may miss its bounds by in a substep, in widths: the tolerance of impacts to
     * the power of three quarters, a thousandth at the game's accuracy. Finer ones ask for more,
     * but passes come nearer by a share each, not by a digit.
     */
    private static double missed(Accuracy accuracy) {
        double root = Math.sqrt(accuracy.impactTolerance());
        return root * Math.sqrt(root);
    }

    /**
     * Begins a step of {@code dt} seconds of the packed island, which is given so many substeps of
     * the usual ones: fewer have to find in more passes what a heap needs to come to rest. Between
     * a wall and what is a thousand times as heavy, few contacts are passed over until none is due:
     * that takes thousands of passes, but no more than the elimination which was given up.
     */
    void begin(double dt, int substeps) {
        step = dt;
        mostOfFew = (int) (most * Math.max(1, Rounds.timesByMass(motions)));
        mostIfCalm = most / 2 * Math.max(1, usual / substeps);
    }

    /**
     * One substep of h seconds, whose kick lasts {@code length} seconds, in which nothing goes
     * faster than {@code fastest} m/s by what contacts carried, and that leaves nothing faster than
     * a limit, m/s; {@code left} seconds of the step are to go. What is struck may turn so fast
     * that it would be on another corner when the substep ends: its contacts are measured again on
     * the way.
     */
    void advance(double h, double length, int substep, double fastest, double limit, double left) {
        hold(h, length, substep, fastest, limit);
        int parts = declared.partsFor(h);
        double part = h / parts;
        motions.drift(part);
        for (int i = 1; i < parts; i++) {
            if (declared.measureTurned(part, left - i * part)) {
                stopTurned(part, substep, fastest, limit);
            }
            motions.drift(part);
        }
        if (isCorrecting) {
            overlap.correctAndHoldGround(h, substep, PASSES_OVER_OVERLAP);
        }
    }

    /**
     * Whether no body of the packed island, which is held, could be parted from another in a
     * substep of h seconds.
     */
    boolean areBlocked(double h) {
        overlap.prepare(true);
        return overlap.isBlocked(h);
    }

    /** Keeps contacts from closing and sliding. */
    void hold(double h, double length, int substep, double fastest, double limit) {
        // Against what is driven and what stands no load is enough. Loads that grow with every pass
        // would lose the digits in which friction holds what is pressed, and throw it out instead.
        sweep.limitPresses(motions.mass() * limit);
        if (contacts.areCrowd()) {
            sweepCrowd(h, length, substep, fastest);
        } else {
            sweepFew(h, length, substep, fastest);
        }
        sweep.limitPresses(Double.POSITIVE_INFINITY);
        guard.limitWork(noise * kick.energy(h));
        guard.limitSpeed(limit);
        contacts.addUpImpulses(1);
    }

    /**
     * Keeps what has turned within a substep from closing in the next part of it, of h seconds.
     * What contacts carried up to here has been done, and cannot be taken back.
     */
    private void stopTurned(double h, int substep, double fastest, double limit) {
        guard.begin();
        earlier.putAside();
        sweep.limitPresses(motions.mass() * limit);
        boolean isCrowd = contacts.areCrowd();
        double share = isCrowd ? MISSED_IN_A_CROWD * missed : missed;
        double quiet = isCrowd ? quietOfCrowd(fastest) : shorter * QUIET * fastest;
        sweep.runNew(h, substep, share, quiet, OF_THE_FASTEST * quiet, most);
        sweep.limitPresses(Double.POSITIVE_INFINITY);
        guard.limitEnergy();
        guard.limitSpeed(limit);
        contacts.addUpImpulses(1);
        earlier.addBack();
    }

    /** Few contacts that sink in are passed over until they do not, or cost too much. */
    private void sweepFew(double h, double length, int substep, double fastest) {
        long start = contacts.work.contactSolves;
        double sunk = SUNK * MISSED_IN_A_CROWD * missed;
        double quiet = shorter * QUIET * fastest;
        sweep.run(h, length, substep, missed, quiet, quiet, mostOfFew);
        while (longer > 0
                && contacts.work.contactSolves - start < MOST_SOLVES_OF_FEW
                && sweep.isSinking(h, substep, sunk)) {
            long before = contacts.work.contactSolves;
            sweep.goOn(mostOfFew);
            if (contacts.work.contactSolves == before) {
                return;
            }
        }
    }

    /**
     * A crowd is solved the more coarsely the faster it moves, but what lies still in it by its own
     * speeds; when all of it is calm in fewer passes, and to the end if it is not too large.
     */
    private void sweepCrowd(double h, double length, int substep, double fastest) {
        boolean isCalm = fastest < CALM * kick.strongest() * step;
        double quiet = quietOfCrowd(fastest);
        int passes = isCalm ? mostIfCalm : most;
        double share = MISSED_IN_A_CROWD * missed;
        double least = isCalm ? quiet : OF_THE_FASTEST * quiet;
        sweep.run(h, length, substep, share, quiet, least, passes);
        int affordable = Math.min(longer, MOST_SOLVES / (passes * contacts.count));
        for (int i = 0; i < affordable && sweep.isSinking(h, substep, SUNK * share); i++) {
            sweep.goOn(passes);
        }
    }

    /** Change of speed that does not count in a crowd, m/s. */
    private double quietOfCrowd(double fastest) {
        double gained = kick.strongest() * step;
        double ofFall = gained > 0 ? Math.min(1, fastest / gained) : 0;
        double quiet = shorter * Math.max(QUIET, ofFall * QUIET_IN_A_CROWD) * fastest;
        return contacts.count > LARGE ? Math.max(quiet, shorter * UNSEEN * missed * gained) : quiet;
    }
}
