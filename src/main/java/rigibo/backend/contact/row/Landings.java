package rigibo.backend.contact.row;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ImpactMode;

/**
 * Times within a substep at which a contact point lands: a corner of a rocking block, a disc that
 * reaches the next plate of a bowl. A contact that is solved for a whole substep stops a body
 * before it arrives and supports it before it is there; both change energy by an error of first
 * order in the length of the substep. In an island of few bodies a substep is therefore cut at each
 * landing.
 */
public final class Landings {

    /**
     * Most parts of a substep. A box may come over six plates in one substep, each of which takes
     * four parts. The rest of the substep is solved in one part, where points land too late.
     */
    private static final int MOST_PARTS = 64;

    /**
     * Speed below which a landing is neglected, as a share of the speed that a substep's kick
     * gives.
     */
    private static final double SOFT = 1e-2;

    /**
     * A body counts as struck if it gained more than this multiple of the speed that its
     * acceleration gives it.
     */
    private static final double IMPACT = 2;

    /**
     * Uncertainty of a gap's acceleration, as a share of the strongest one: bodies turn and loads
     * change meanwhile, and landing a little late costs more than landing early.
     */
    private static final double UNSURE = 0.1;

    /** Gap at which a body has landed, as a share of the impact tolerance. */
    private static final double LANDED = 0.1;

    /** Least such gap, in widths, since speeds are not predicted to the last digit. */
    private static final double LEAST_LANDED = 1e-6;

    private final Motions motions;
    private final PackedContacts contacts;
    private final Kick kick;
    private final boolean isLookedForAtAll;

    /** Gap in widths at which a body has landed. */
    private final double landed;

    /** Whether landings in the packed island are looked for. */
    private boolean isLookedFor;

    /** Parts of the present substep so far. */
    private int parts;

    /** Velocities at the start of the last part, laid out as the motions. */
    private double[] before = new double[(Motions.FEW + 1) * Motions.STRIDE];

    /** Their gain per second in the last part, laid out as the motions. */
    private double[] gained = new double[(Motions.FEW + 1) * Motions.STRIDE];

    /** By body: whether it was struck in the last part. */
    private boolean[] isStruck = new boolean[Motions.FEW + 1];

    /** By point: whether it had a gap when the last part began. */
    private boolean[] isOpen = new boolean[32];

    /** By point: whether it has landed in the last part. */
    private boolean[] hasLanded = new boolean[32];

    /** Whether the last part began with a landing, whose impact is included in the gains. */
    private boolean beganByLanding;

    /** Length of the last part, s; 0 if velocities are those of the present time. */
    private double lastPart;

    /** Length of the kick in the middle of the last part, s. */
    private double kicked;

    public Landings(Motions motions, PackedContacts contacts, Kick kick, Accuracy accuracy) {
        isLookedForAtAll = accuracy.impacts() == ImpactMode.EVENTS;
        landed = Math.max(LEAST_LANDED, LANDED * accuracy.impactTolerance());
        this.motions = motions;
        this.contacts = contacts;
        this.kick = kick;
    }

    /** Starts a packed island. */
    public void begin() {
        isLookedFor = isLookedForAtAll && motions.areFew() && contacts.lastJoining <= 0;
        lastPart = 0;
    }

    /** Whether landings are looked for in the packed island. */
    public boolean areLookedFor() {
        return isLookedFor;
    }

    /** Starts a substep. */
    public void beginSubstep() {
        parts = 0;
    }

    /**
     * Whether a point has landed in the last part, of a substep of h seconds. Until {@link #close}
     * it counts as far away, since it carries nothing of the kick that ends here.
     */
    public boolean haveLanded(double h) {
        double soft = soft(h);
        boolean isAny = false;
        for (int i = 0; isLookedFor && lastPart > 0 && i < 2 * contacts.count; i++) {
            hasLanded[i] = isOpen[i] && isPoint(i) && gap(i) <= near(i) && closing(i) > soft;
            if (hasLanded[i]) {
                isAny = true;
                widen(i, contacts.width(i / 2));
            }
        }
        return isAny;
    }

    /**
     * Closes the gaps of the points that have landed, so that they are solved as touching from the
     * next kick on.
     */
    public void close() {
        lastPart = 0;
        for (int i = 0; i < 2 * contacts.count; i++) {
            if (hasLanded[i]) {
                widen(i, -gap(i));
            }
        }
    }

    /**
     * Keeps the gaps of landed points closed for as long as they carry, in a substep of h seconds.
     * A point that the last kick left out as an impact counts as carrying, since its body must not
     * fall for half a kick. Gaps that open by turning stay open, and so do those of bodies that a
     * driven body squeezes, which cannot fall.
     */
    public void keepClosed(double h) {
        boolean mayFall = isLookedFor && !motions.isAnyDriven;
        for (int i = 0; mayFall && i < 2 * contacts.count; i++) {
            if (isPoint(i) && contacts.carries(i / 2, i % 2)) {
                double gap = gap(i);
                if (gap > 0 && gap <= near(i) && turned(i, h) <= near(i)) {
                    widen(i, -gap);
                }
            }
        }
    }

    /** Sagitta by which the outlines of a contact deviate from lines in h seconds by turning, m. */
    private double turned(int i, double h) {
        return sagitta(contacts.bodyA[i / 2], h) + sagitta(contacts.bodyB[i / 2], h);
    }

    private double sagitta(int at, double h) {
        double turn = motions.data[at + Motions.SPIN] * h;
        return turn * turn / 2 * motions.reach[at / Motions.STRIDE];
    }

    private void widen(int i, double by) {
        contacts.data[i / 2 * PackedContacts.STRIDE + PackedContacts.GAP0 + i % 2] += by;
    }

    /**
     * Time until the next landing, within the rest (h seconds) of a substep, s. It is at most
     * {@code most}, since later other points may land.
     */
    public double untilNext(double h, double most) {
        if (!isLookedFor) {
            return h;
        }
        measureGain();
        beganByLanding = lastPart == 0;
        noteOpen();
        double until = ++parts < MOST_PARTS ? Math.min(firstLanding(h), most) : h;
        System.arraycopy(motions.data, 0, before, 0, motions.count * Motions.STRIDE);
        kicked = (lastPart + until) / 2;
        lastPart = until;
        return until;
    }

    /** Predicts gains of velocity from the last part, except gains by an impact. */
    private void measureGain() {
        double most = IMPACT * kick.strongest() * kicked;
        for (int body = 1; body < motions.count; body++) {
            int at = body * Motions.STRIDE;
            double x = motions.data[at + Motions.VX] - before[at + Motions.VX];
            double y = motions.data[at + Motions.VY] - before[at + Motions.VY];
            double turn = motions.data[at + Motions.SPIN] - before[at + Motions.SPIN];
            isStruck[body] = lastPart == 0 || beganByLanding || Math.abs(x) + Math.abs(y) > most;
            gained[at + Motions.VX] = x / kicked;
            gained[at + Motions.VY] = y / kicked;
            gained[at + Motions.SPIN] = turn / kicked;
        }
    }

    private void noteOpen() {
        if (isOpen.length < 2 * contacts.count) {
            isOpen = new boolean[2 * contacts.pair.length];
            hasLanded = new boolean[2 * contacts.pair.length];
        }
        for (int i = 0; i < 2 * contacts.count; i++) {
            isOpen[i] = isPoint(i) && gap(i) > near(i);
        }
    }

    /**
     * The time of the first landing: when the gap is small enough to count as landed, but not so
     * small that the contact would already have stopped the body. Places are predicted with the
     * velocity at the middle of a part, as the substep advances them.
     */
    private double firstLanding(double h) {
        double soft = soft(h);
        double until = h;
        for (int i = 0; i < 2 * contacts.count; i++) {
            if (isOpen[i]) {
                double gains = gains(i);
                double closing = closing(i) + gains * lastPart / 2;
                double way = gap(i) - near(i) / 2;
                double square = closing * closing + 2 * gains * way;
                double after = 2 * way / (closing + Math.sqrt(square));
                if (after > 0 && closing + gains * after > soft) {
                    until = Math.min(until, after);
                }
            }
        }
        return until;
    }

    /**
     * Closing acceleration of a point, m/s². Where the loads of contacts are not known yet it is an
     * upper bound: a part that ends too early is better than one that ends too late, since the next
     * part knows the loads.
     */
    private double gains(int i) {
        int a = contacts.bodyA[i / 2];
        int b = contacts.bodyB[i / 2];
        return isStruck[a / Motions.STRIDE] || isStruck[b / Motions.STRIDE]
                ? IMPACT * kick.strongest()
                : UNSURE * kick.strongest() - motions.parting(gained, contacts, i / 2, i % 2);
    }

    /** Speed below which a landing in a substep of h seconds is neglected, m/s. */
    private double soft(double h) {
        return SOFT * h * kick.strongest();
    }

    private boolean isPoint(int i) {
        return i % 2 < contacts.points[i / 2];
    }

    private double gap(int i) {
        return motions.gap(contacts, i / 2, i % 2);
    }

    private double closing(int i) {
        return -motions.parting(contacts, i / 2, i % 2);
    }

    private double near(int i) {
        return landed * contacts.width(i / 2);
    }
}
