package rigibo.backend.contact.row;

import rigibo.backend.setup.Accuracy;

/** The speed at which overlap is removed, and how much of it is kept. */
public final class Recovery {

    /** Share of an overlap that is removed per second, 1/s; two steps halve an overlap. */
    public static final double RATE = 25;

    /** Highest speed at which two overlapping bodies are moved apart, widths per second. */
    public static final double MOST_PUSH = 3;

    /**
     * Kept overlap, in widths: a resting contact that parted by round-off would lose its load for a
     * substep and tremble.
     */
    public static final double KEPT_OVERLAP = 1e-5;

    /**
     * Largest kept overlap in a crowd, in widths. Pushing one body of a crowd opens gaps around
     * others, which keep closing for as long as any overlap is removed.
     */
    private static final double MOST_KEPT = 1e-3;

    /** Kept overlap in a crowd, as a multiple of the impact tolerance. */
    private static final double KEPT_BY_TOLERANCE = 10;

    /**
     * Factor on it in a calm crowd. The last of an overlap is removed ever more slowly, and as long
     * as any is removed, the crowd does not rest.
     */
    private static final double KEPT_IF_CALM = 2;

    private Recovery() {}

    /**
     * Distance by which a contact's gap is to open in h seconds, m, with a highest speed in widths
     * per second; 0 if the overlap is within the kept one, in widths.
     */
    public static double opens(
            PackedContacts contacts, int contact, double gap, double kept, double h, double most) {
        int at = contact * PackedContacts.STRIDE;
        double width = contacts.data[at + PackedContacts.WIDTH];
        double over = -gap - kept * width;
        double rate = contacts.data[at + PackedContacts.RECOVERY] * h;
        return over > 0 ? Math.min(over * rate / (1 + rate), most * width * h) : 0;
    }

    /** Overlap, m, of which so many m are removed in a step of dt seconds. */
    public static double overlapOf(double removed, double dt) {
        return removed * (1 + 1 / (RATE * dt));
    }

    /** Kept overlap, in widths; in a crowd ten times the impact tolerance, within bounds. */
    public static double kept(boolean isCrowd, Accuracy accuracy) {
        if (!isCrowd) {
            return KEPT_OVERLAP;
        }
        double wanted = KEPT_BY_TOLERANCE * accuracy.impactTolerance();
        return Math.max(KEPT_OVERLAP, Math.min(MOST_KEPT, wanted));
    }

    /** Kept overlap of a calm island, in widths. */
    public static double keptIfCalm(boolean isCrowd, Accuracy accuracy) {
        double kept = kept(isCrowd, accuracy);
        return isCrowd ? KEPT_IF_CALM * kept : kept;
    }
}
