package rigibo.backend.contact.row;

import rigibo.backend.setup.Accuracy;

/** How fast overlap is taken back, and how much of it stays. */
public final class Recovery {

    /** Share of an overlap taken back per second; an overlap has halved after two steps. */
    public static final double RATE = 25;

    /** Fastest speed at which two overlapping bodies are moved apart, m/s for a body of a metre. */
    public static final double MOST_PUSH = 3;

    /**
     * Overlap that stays, m for a body of one metre: a resting contact that parted by round-off
     * would lose its load for a substep and tremble.
     */
    public static final double KEPT_OVERLAP = 1e-5;

    /**
     * The most that stays in a crowd, m for a body of one metre. What pushes one of its bodies
     * opens gaps around others, which close again for as long as anything is taken back.
     */
    private static final double MOST_KEPT = 1e-3;

    /** How many times the tolerance of impacts that is. */
    private static final double KEPT_BY_TOLERANCE = 10;

    /**
     * How many times that may stay in a crowd that is calm. What is taken back of the last of an
     * overlap is ever less, and as long as anything is, nothing rests.
     */
    private static final double KEPT_IF_CALM = 2;

    private Recovery() {}

    /**
     * How far in m a gap of a contact is to open in h seconds, at so many widths a second at most;
     * 0 where no more overlaps than is kept, in widths.
     */
    public static double opens(
            PackedContacts contacts, int contact, double gap, double kept, double h, double most) {
        int at = contact * PackedContacts.STRIDE;
        double width = contacts.data[at + PackedContacts.WIDTH];
        double over = -gap - kept * width;
        double rate = contacts.data[at + PackedContacts.RECOVERY] * h;
        return over > 0 ? Math.min(over * rate / (1 + rate), most * width * h) : 0;
    }

    /** How deep an overlap is, m, of which so many m are taken back in a step of dt seconds. */
    public static double overlapOf(double taken, double dt) {
        return taken * (1 + 1 / (RATE * dt));
    }

    /**
     * Overlap that stays, m for a body of one metre. In a crowd that is ten times the tolerance of
     * impacts, within bounds.
     */
    public static double kept(boolean isCrowd, Accuracy accuracy) {
        if (!isCrowd) {
            return KEPT_OVERLAP;
        }
        double wanted = KEPT_BY_TOLERANCE * accuracy.impactTolerance();
        return Math.max(KEPT_OVERLAP, Math.min(MOST_KEPT, wanted));
    }

    /**
     * Overlap that stays in an island in which nothing goes faster than a quarter of what its own
     * pull gives it in a step, m for a body of one metre.
     */
    public static double keptIfCalm(boolean isCrowd, Accuracy accuracy) {
        double kept = kept(isCrowd, accuracy);
        return isCrowd ? KEPT_IF_CALM * kept : kept;
    }
}
