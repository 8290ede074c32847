package rigibo.backend.contact.row;

/**
 * What contacts have carried so far in a substep, put aside while they answer what happens later in
 * it: an impulse that has been given is not taken back when the two part.
 */
public final class EarlierImpulses {

    private static final int[] COLUMNS = {
        PackedContacts.IMPULSE0,
        PackedContacts.IMPULSE1,
        PackedContacts.IMPULSE_T,
        PackedContacts.IMPULSE_R
    };

    private final PackedContacts contacts;

    /** By row and column, N·s and N·m·s. */
    private double[] impulses = new double[16 * COLUMNS.length];

    public EarlierImpulses(PackedContacts contacts) {
        this.contacts = contacts;
    }

    /** Takes all contacts for ones that have carried nothing yet. */
    public void putAside() {
        if (impulses.length < contacts.count * COLUMNS.length) {
            impulses = new double[contacts.pair.length * COLUMNS.length];
        }
        int i = 0;
        for (int row = 0; row < contacts.count; row++) {
            for (int column : COLUMNS) {
                impulses[i++] = contacts.data[row * PackedContacts.STRIDE + column];
            }
        }
        contacts.unload();
    }

    /** Adds what was put aside to what they have carried since. */
    public void addBack() {
        int i = 0;
        for (int row = 0; row < contacts.count; row++) {
            for (int column : COLUMNS) {
                contacts.data[row * PackedContacts.STRIDE + column] += impulses[i++];
            }
        }
    }
}
