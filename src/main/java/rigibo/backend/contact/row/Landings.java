package rigibo.backend.contact.row;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ImpactMode;

/**
 * Times within a substep at which something lands: a corner of a rocking block, a disc that reaches
 * the next plate of a bowl. A contact that is solved for a whole substep stops a body before it has
 * arrived, and carries it before it is there; both cost energy in proportion to the length of a
 * substep. So in an island of few bodies a substep ends where one of them lands.
 */
public final class Landings {

    /**
     * Parts that a substep is taken in at most. A box may come over six plates in one, each of
     * which takes four; whatever is left is solved in one go, and lands too late.
     */
    private static final int MOST_PARTS = 64;

    /**
     * Speed of a landing that is neglected, as a share of the speed that a substep's kick gives.
     */
    private static final double SOFT = 1e-2;

    /**
     * Factor by which a body must be faster than its acceleration explains for it to have been
     * struck.
     */
    private static final double IMPACT = 2;

    /**
     * Share of the strongest acceleration that what is known of a gap may be wrong by, since bodies
     * turn and loads change meanwhile: landing a little late costs more than landing early.
     */
    private static final double UNSURE = 0.1;

    /** Share of the tolerance of impacts that a landed body may be above the ground. */
    private static final double LANDED = 0.1;

    /** That in widths at the finest accuracy: speeds are not foreseen to the last digit. */
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

    /** Velocities as the last part began, and what they gained in it a second, as the motions. */
    private double[] before = new double[(Motions.FEW + 1) * Motions.STRIDE];

    private double[] gained = new double[(Motions.FEW + 1) * Motions.STRIDE];

    /** By body: whether it gained more than its acceleration explains. */
    private boolean[] isStruck = new boolean[Motions.FEW + 1];

    /** By point: whether it had a gap as the last part began, and whether it has landed since. */
    private boolean[] isOpen = new boolean[32];

    private boolean[] hasLanded = new boolean[32];

    /** Whether the last part began with a landing, whose impact is in what bodies gained. */
    private boolean beganByLanding;

    /** How long the last part was, s, 0 where a kick begins anew; and the kick in its midst. */
    private double lastPart;

    private double kicked;

    public Landings(Motions motions, PackedContacts contacts, Kick kick, Accuracy accuracy) {
        isLookedForAtAll = accuracy.impacts() == ImpactMode.EVENTS;
        landed = Math.max(LEAST_LANDED, LANDED * accuracy.impactTolerance());
        this.motions = motions;
        this.contacts = contacts;
        this.kick = kick;
    }

    /** Begins a packed island. */
    public void begin() {
        isLookedFor = isLookedForAtAll && motions.areFew() && contacts.lastJoining <= 0;
        lastPart = 0;
    }

    /** Whether any are looked for in the packed island. */
    public boolean areLookedFor() {
        return isLookedFor;
    }

    /** Begins a substep. */
    public void beginSubstep() {
        parts = 0;
    }

    /**
     * Whether something has landed in the part that has just gone by, of a substep of h seconds.
     * Until {@link #close} it counts as far away: it carries nothing of the kick that ends here.
     */
    public boolean haveLanded(double h) {
        double soft = soft(h);
        boolean isAny = false;
        for (int i = 0; isLookedFor && lastPart > 0 && i < 2 * contacts.count; i++) {
            hasLanded[i] = isOpen[i] && isPoint(i) && gap(i) <= near(i) && closing(i) > soft;
            if (hasLanded[i]) {
                isAny = true;
                widen(i, contacts.data[i / 2 * PackedContacts.STRIDE + PackedContacts.WIDTH]);
            }
        }
        return isAny;
    }

    /**
     * Closes the gaps of the points that have landed, so that they are solved at once; a kick
     * begins anew.
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
     * Closes the gaps at which points have landed for as long as they carry, in a substep of h
     * seconds. What the kick before left out as an impact carries too: its body must not fall for
     * half a kick. What turns opens gaps by itself, and what a driven body squeezes does not fall.
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

    /** How far in m the outlines of a contact leave their lines in h seconds, by turning. */
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
     * How much of the h seconds that are left of a substep go by until something lands, s; no more
     * than {@code most}, for as long what may land is known.
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

    /** What bodies gained in the last part they go on to gain, if no impact gave it to them. */
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
     * The time of the first landing: when the gap is as small as counts as landed, but not so small
     * that the contact would stop the body already. Places go on by the velocity in the middle of a
     * part, as they do in the substep.
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
     * How fast a point's gap gains closing speed, m/s². Where the loads of contacts are not known
     * yet it is more than it can be: a part that ends too early is better than one that ends too
     * late, for the next part knows them.
     */
    private double gains(int i) {
        int a = contacts.bodyA[i / 2];
        int b = contacts.bodyB[i / 2];
        return isStruck[a / Motions.STRIDE] || isStruck[b / Motions.STRIDE]
                ? IMPACT * kick.strongest()
                : UNSURE * kick.strongest() - motions.parting(gained, contacts, i / 2, i % 2);
    }

    /** Speed of a landing in a substep of h seconds that counts as none, m/s. */
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
        return landed * contacts.data[i / 2 * PackedContacts.STRIDE + PackedContacts.WIDTH];
    }
}
