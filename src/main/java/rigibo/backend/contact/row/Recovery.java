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
     * Overlap that stays among so many contacts, m for a body of one metre. In a crowd that is ten
     * times the tolerance of impacts, within bounds.
     */
    public static double kept(int contacts, Accuracy accuracy) {
        if (!PackedContacts.areCrowd(contacts)) {
            return KEPT_OVERLAP;
        }
        double wanted = KEPT_BY_TOLERANCE * accuracy.impactTolerance();
        return Math.max(KEPT_OVERLAP, Math.min(MOST_KEPT, wanted));
    }

    /**
     * The same where nothing goes faster than its own pull would make it in a quarter of a step.
     */
    public static double keptIfCalm(int contacts, Accuracy accuracy) {
        double kept = kept(contacts, accuracy);
        return PackedContacts.areCrowd(contacts) ? KEPT_IF_CALM * kept : kept;
    }
}
