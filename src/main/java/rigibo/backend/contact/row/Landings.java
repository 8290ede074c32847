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

    /** Parts that a substep is taken in at most. */
    private static final int MOST_PARTS = 8;

    /**
     * Speed of a landing that is neglected, as a share of the speed that a substep's kick gives.
     */
    private static final double SOFT = 1e-2;

    /**
     * Factor by which a body must be faster than its acceleration explains for it to have been
     * struck.
     */
    private static final double IMPACT = 2;

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

    /** Velocities as the last part began, laid out as the motions. */
    private double[] before = new double[(Motions.FEW + 1) * Motions.STRIDE];

    private double[] now = new double[(Motions.FEW + 1) * Motions.STRIDE];

    /** By point: whether it had a gap as the last part began, and whether it has landed since. */
    private boolean[] isOpen = new boolean[32];

    private boolean[] hasLanded = new boolean[32];

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

    private void widen(int i, double by) {
        contacts.data[i / 2 * PackedContacts.STRIDE + PackedContacts.GAP0 + i % 2] += by;
    }

    /** How much of the h seconds that are left of a substep go by until something lands, s. */
    public double untilNext(double h) {
        if (!isLookedFor) {
            return h;
        }
        int length = motions.count * Motions.STRIDE;
        System.arraycopy(motions.data, 0, now, 0, length);
        foresee(h, length);
        noteOpen();
        double until = ++parts < MOST_PARTS ? firstLanding(h) : h;
        System.arraycopy(now, 0, motions.data, 0, length);
        double[] swap = before;
        before = now;
        now = swap;
        kicked = (lastPart + until) / 2;
        lastPart = until;
        return until;
    }

    /** Lets all go on as they did, if no impact did it. */
    private void foresee(double h, int length) {
        if (lastPart == 0) {
            return;
        }
        double ahead = (lastPart + h) / (2 * kicked);
        double most = IMPACT * kick.strongest() * kicked;
        for (int at = Motions.STRIDE; at < length; at += Motions.STRIDE) {
            double x = now[at + Motions.VX] - before[at + Motions.VX];
            double y = now[at + Motions.VY] - before[at + Motions.VY];
            if (Math.abs(x) + Math.abs(y) <= most) {
                double turn = now[at + Motions.SPIN] - before[at + Motions.SPIN];
                motions.data[at + Motions.VX] += ahead * x;
                motions.data[at + Motions.VY] += ahead * y;
                motions.data[at + Motions.SPIN] += ahead * turn;
            }
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
     * that the contact would stop the body already.
     */
    private double firstLanding(double h) {
        double soft = soft(h);
        double unknown = unknown(h);
        double until = h;
        for (int i = 0; i < 2 * contacts.count; i++) {
            if (isOpen[i] && closing(i) > soft) {
                double closing = closing(i) + unknown;
                until = Math.min(until, (gap(i) - near(i) / 2) / closing);
            }
        }
        return until;
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

    /**
     * What may still be added to that by the middle of a part of h seconds. In the first part of a
     * step the loads of contacts are not known yet; a part that ends too early is better than one
     * that ends too late, for the next part knows them.
     */
    private double unknown(double h) {
        return lastPart > 0 ? 0 : IMPACT * kick.strongest() * h / 2;
    }

    private double near(int i) {
        return landed * contacts.data[i / 2 * PackedContacts.STRIDE + PackedContacts.WIDTH];
    }
}
