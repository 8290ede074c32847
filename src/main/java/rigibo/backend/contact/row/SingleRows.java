package rigibo.backend.contact.row;

/**
 * The single rows of packed contacts: row {@code 3·contact + kind}, where kind is the point of a
 * normal row, 0 or 1, or {@link #TANGENT}.
 */
public final class SingleRows {

    public static final int ROWS_PER_CONTACT = 3;
    public static final int TANGENT = 2;

    /** Most rows of an island that is eliminated; for larger ones it costs more than it gains. */
    public static final int MOST_ELIMINATED = 192;

    private final PackedContacts contacts;

    public SingleRows(PackedContacts contacts) {
        this.contacts = contacts;
    }

    /** Speed of B relative to A along a row, from columns as in the motions, m/s. */
    public double relative(double[] m, int id) {
        int row = id / ROWS_PER_CONTACT;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        return directionX(id) * (m[b + Motions.VX] - m[a + Motions.VX])
                + directionY(id) * (m[b + Motions.VY] - m[a + Motions.VY])
                + leverB(id) * m[b + Motions.SPIN]
                - leverA(id) * m[a + Motions.SPIN];
    }

    /** Applies an impulse along a row to columns laid out as the motions. */
    public void push(double[] m, int id, double impulse) {
        int row = id / ROWS_PER_CONTACT;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double ma = m[a + Motions.INVERSE_MASS] * impulse;
        double mb = m[b + Motions.INVERSE_MASS] * impulse;
        m[a + Motions.VX] -= ma * directionX(id);
        m[a + Motions.VY] -= ma * directionY(id);
        m[a + Motions.SPIN] -= m[a + Motions.INVERSE_INERTIA] * leverA(id) * impulse;
        m[b + Motions.VX] += mb * directionX(id);
        m[b + Motions.VY] += mb * directionY(id);
        m[b + Motions.SPIN] += m[b + Motions.INVERSE_INERTIA] * leverB(id) * impulse;
    }

    /** Column of a row's impulse, relative to its contact's first one. */
    public static int impulseColumn(int id) {
        int kind = id % ROWS_PER_CONTACT;
        return kind == TANGENT ? PackedContacts.IMPULSE_T : PackedContacts.IMPULSE0 + kind;
    }

    /** Speed of the running surfaces along a row, m/s. */
    public double running(int id) {
        return id % ROWS_PER_CONTACT == TANGENT ? contacts.running[id / ROWS_PER_CONTACT] : 0;
    }

    private double directionX(int id) {
        int at = id / ROWS_PER_CONTACT * PackedContacts.STRIDE;
        return id % ROWS_PER_CONTACT == TANGENT
                ? -contacts.data[at + PackedContacts.NY]
                : contacts.data[at + PackedContacts.NX];
    }

    private double directionY(int id) {
        int at = id / ROWS_PER_CONTACT * PackedContacts.STRIDE;
        return id % ROWS_PER_CONTACT == TANGENT
                ? contacts.data[at + PackedContacts.NX]
                : contacts.data[at + PackedContacts.NY];
    }

    private double leverA(int id) {
        int at = id / ROWS_PER_CONTACT * PackedContacts.STRIDE;
        int kind = id % ROWS_PER_CONTACT;
        return contacts.data[
                at
                        + (kind == TANGENT
                                ? PackedContacts.LEVER_TA
                                : PackedContacts.LEVER_A0 + 2 * kind)];
    }

    private double leverB(int id) {
        int at = id / ROWS_PER_CONTACT * PackedContacts.STRIDE;
        int kind = id % ROWS_PER_CONTACT;
        return contacts.data[
                at
                        + (kind == TANGENT
                                ? PackedContacts.LEVER_TB
                                : PackedContacts.LEVER_B0 + 2 * kind)];
    }
}
