package rigibo.backend.contact.row;

/** The speed at which overlap is removed. */
public final class Recovery {

    /** Share of an overlap that is removed per second, 1/s; two steps halve an overlap. */
    public static final double RATE = 25;

    /** Highest speed at which two overlapping bodies are moved apart, widths per second. */
    public static final double MOST_PUSH = 3;

    /** Share by which displacements stay below that speed, to allow for their round-off. */
    private static final double WAY_ROUND_OFF = 1e-9;

    private Recovery() {}

    /** Largest displacement by which overlap is removed in h seconds, widths. */
    public static double mostWay(double h) {
        return (1 - WAY_ROUND_OFF) * MOST_PUSH * h;
    }

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

    /** Overlap, m, of which a step of dt seconds removes {@code removed} m. */
    public static double overlapOf(double removed, double dt) {
        return removed * (1 + 1 / (RATE * dt));
    }
}
