package rigibo.backend.contact;

import rigibo.backend.contact.row.EarlierImpulses;
import rigibo.backend.contact.row.Effort;
import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.MissedWidth;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.solve.ContactSweep;
import rigibo.backend.contact.solve.EnergyGuard;
import rigibo.backend.contact.solve.OverlapSolver;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.Correction;

/**
 * Advances an island, substep by substep, by passes over its contacts. Overlapping bodies are moved
 * apart without giving them speed.
 */
public final class Passes {

    /**
     * Change of speed that is neglected, as a share of the island's fastest speed. The share is
     * smaller for substeps longer than the game's, since their kicks add more.
     */
    private static final double QUIET = 0.03;

    /**
     * Counterpart of {@link #QUIET} for a crowd that falls or is struck. It shrinks as the crowd
     * slows down; otherwise the crowd would never come to rest. {@link ContactSweep} solves
     * contacts that sink in strictly, whatever the share.
     */
    private static final double QUIET_IN_A_CROWD = 0.1;

    /**
     * Speed below which a crowd counts as calm and gets half the passes, as a share of a free
     * body's gain of speed in a step.
     */
    private static final double CALM = 0.25;

    /**
     * Change of speed that is neglected in a large crowd, as a multiple of a free body's gain of
     * speed in a step times {@code missed}: 5 µm/s at the game's accuracy. The error of a body
     * squeezed between two others is many times the change in a pass, and the heap stays awake
     * while that body creeps.
     */
    private static final double UNSEEN = 0.03;

    /** Number of contacts above which a crowd counts as large. */
    private static final int LARGE = 512;

    /**
     * Change of speed that is neglected where a crowd lies still, as a share of the one that is
     * neglected in the whole crowd.
     */
    private static final double OF_THE_FASTEST = 0.05;

    /**
     * Divisor of the cube of the number of substeps; the quotient limits the passes per substep.
     * Twice the substeps halve the threshold about five times, and each halving takes as many
     * passes again.
     */
    private static final int CUBES_PER_PASS = 2;

    private static final int LEAST_PASSES = 16;

    /**
     * Least limit of passes per step in a calm crowd, as many as at the game's accuracy. With an
     * eighth of them, a third of heaps of a few hundred boxes crept at {@code DRAFT} and never
     * slept.
     */
    private static final int CALM_PASSES = 64;

    /**
     * Speed, as a share of a free body's gain of speed in a step, below which a crowd gets no fewer
     * passes than a calm one. High heaps at {@code DRAFT} rocked on, too fast to count as calm: the
     * few passes that were left to them moved loads too late, and so drove them.
     */
    private static final double SLOW = 0.5;

    /** Factor on {@code missed} in a crowd. */
    private static final double MISSED_IN_A_CROWD = 3;

    /**
     * Multiple of {@code missed} by which a contact may sink in before further passes are made. The
     * usual passes do not suffice for an impact that many bodies hand down to the ground.
     */
    private static final double SUNK = 2;

    /**
     * Depth from which contacts that sink in hand impulses down to the ground, as a share of {@code
     * missed}. They do so once any contact sinks in by more than {@code missed}.
     */
    private static final double HANDED_DOWN = 0.1;

    /** Divisor of the number of passes after impulses are handed down. */
    private static final int AFTER_HANDING_DOWN = 4;

    /** Most repetitions of the passes for contacts that sink in. */
    private static final int LONGER = 7;

    /** Most contact solutions in the repetitions of a substep; bounds a crowd's slowest step. */
    private static final int MOST_SOLVES = 80_000;

    /**
     * Most contact solutions per substep for contacts that sink in, in an island that is no crowd.
     * The worst case is a bullet that presses a body of a thousandth of its mass against a wall.
     */
    private static final int MOST_SOLVES_OF_FEW = 400_000;

    /** Most passes per substep: the number at {@code EXACT}; more have no effect. */
    private static final int MOST_PASSES = 2048;

    /** Passes over overlap in a substep; the next substep continues. */
    private static final int PASSES_OVER_OVERLAP = 6;

    /**
     * Energy that the contacts of a substep may add, as a share of the energy that a kick of the
     * game's length gives to bodies at rest.
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

    /** Allowed error of a contact in a substep, in widths. */
    private final double missed;

    /** Number of substeps relative to the game's, at most 1. */
    private final double shorter;

    /** Most repetitions of the passes; 0 at {@code DRAFT}, where bodies may sink in. */
    private final int longer;

    private final double noise;
    private final boolean isCorrecting;

    /** Whether half kicks get fewer passes. */
    private final boolean isThrifty;

    private final int most;
    private final int usual;

    /** Most passes per substep in a crowd. */
    private int mostOfCrowd;

    /** Most passes per substep in a calm crowd. */
    private int mostIfCalm;

    /** Most passes per substep in an island of few contacts; grows with the ratio of masses. */
    private int mostOfFew;

    /** Least limit of passes per substep in a slow crowd: half of a step's, for half a kick. */
    private final int leastIfSlow;

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
        missed = MissedWidth.of(accuracy);
        isCorrecting = accuracy.correction() == Correction.SOFT;
        usual = accuracy.substeps();
        shorter = Math.min(1, Effort.timesGame(accuracy));
        longer = Effort.isThorough(accuracy) ? LONGER : 0;
        isThrifty = !Effort.isExact(accuracy);
        noise = NOISE * shorter * shorter;
        int passes = Math.max(LEAST_PASSES, usual * usual * usual / CUBES_PER_PASS);
        most = Math.min(MOST_PASSES, accuracy.velocityIterations() * passes);
        leastIfSlow = CALM_PASSES / (2 * usual);
    }

    /**
     * Starts a step of {@code dt} seconds of the packed island in the given number of substeps.
     *
     * <p>With fewer substeps than usual, a heap needs more passes in each to come to rest. A heap
     * that still moves gets them at {@code EXACT} alone, where loads that are too large would lift
     * it; at other presets the time of its slowest step counts for more.
     *
     * <p>Few contacts are solved until none is due. A body between a wall and another of a thousand
     * times its mass takes thousands of passes, but no more work than the elimination that was
     * given up.
     */
    void begin(double dt, int substeps) {
        step = dt;
        mostOfFew = (int) (most * Math.max(1, EliminationBudget.timesByMass(motions)));
        int times = Math.max(1, usual / substeps);
        mostOfCrowd = isThrifty ? most : most * times;
        mostIfCalm = Math.max(most / 2, CALM_PASSES / usual) * times;
    }

    /**
     * Makes one substep.
     *
     * @param h length of the substep, s
     * @param length length of its kick, s
     * @param substep its number
     * @param fastest fastest speed after the warm start, m/s
     * @param limit greatest speed that contacts may leave, m/s
     * @param left rest of the step, s
     */
    void advance(double h, double length, int substep, double fastest, double limit, double left) {
        hold(h, length, substep, fastest, limit);
        drift(h, substep, fastest, limit, left);
        if (isCorrecting) {
            overlap.correctAndHoldGround(h, substep, PASSES_OVER_OVERLAP);
        }
    }

    /**
     * Lets bodies drift for h seconds. A struck body may turn so fast that it comes to stand on
     * another corner; its contacts are then measured again on the way.
     *
     * @return whether any contact was measured
     */
    boolean drift(double h, int substep, double fastest, double limit, double left) {
        int parts = declared.partsFor(h);
        double part = h / parts;
        boolean isAny = false;
        motions.drift(part);
        for (int i = 1; i < parts; i++) {
            if (declared.measureTurned(part, left - i * part)) {
                stopTurned(part, substep, fastest, limit);
                isAny = true;
            }
            motions.drift(part);
        }
        return isAny;
    }

    /**
     * Whether the removal of overlap would move no body in a substep of h seconds. The packed
     * island is held.
     */
    boolean areBlocked(double h) {
        overlap.prepare(true);
        return overlap.isBlocked(h);
    }

    /** Solves contacts, so that they neither close nor slide. */
    void hold(double h, double length, int substep, double fastest, double limit) {
        // No load stops a driven body that presses another against an immovable one. Without a
        // limit the load would grow with every pass and lose the digits of the friction that holds
        // the pressed body, which would be thrown out.
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
     * Solves contacts that were measured again within a substep, for its next part of h seconds.
     * The impulses so far in the substep have acted and cannot be taken back.
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

    /** Solves few contacts; repeats the passes until none sinks in or they cost too much. */
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
     * Solves a crowd. A faster crowd is solved more coarsely, except where bodies in it lie still.
     * A calm crowd gets fewer passes.
     */
    private void sweepCrowd(double h, double length, int substep, double fastest) {
        double gained = kick.strongest() * step;
        boolean isCalm = fastest < CALM * gained;
        double quiet = quietOfCrowd(fastest);
        int leastPasses = fastest < SLOW * gained ? leastIfSlow : 0;
        int passes = isCalm ? mostIfCalmAfter(length / h) : Math.max(mostOfCrowd, leastPasses);
        double error = MISSED_IN_A_CROWD * missed;
        double least = isCalm ? quiet : OF_THE_FASTEST * quiet;
        sweep.run(h, length, substep, error, quiet, least, passes);
        if (sweep.isSinking(h, substep, missed)) {
            sweep.handDown(HANDED_DOWN * missed);
            sweep.goOn(passes / AFTER_HANDING_DOWN);
        }
        int affordable = Math.min(longer, MOST_SOLVES / (passes * contacts.count));
        for (int i = 0; i < affordable && sweep.isSinking(h, substep, SUNK * error); i++) {
            sweep.goOn(passes);
        }
    }

    /**
     * Most passes in a calm crowd after a kick, whose length is stated in substeps. The half kicks
     * at both ends of a step bring half the load and get half the passes, except at {@code EXACT},
     * where nothing may be left.
     */
    private int mostIfCalmAfter(double length) {
        return isThrifty ? (int) Math.ceil(Math.min(1, length) * mostIfCalm) : mostIfCalm;
    }

    /** Change of speed that is neglected in a crowd, m/s. */
    private double quietOfCrowd(double fastest) {
        double gained = kick.strongest() * step;
        double ofFall = gained > 0 ? Math.min(1, fastest / gained) : 0;
        double quiet = shorter * Math.max(QUIET, ofFall * QUIET_IN_A_CROWD) * fastest;
        return contacts.count > LARGE ? Math.max(quiet, shorter * UNSEEN * missed * gained) : quiet;
    }
}
