package rigibo.backend.contact.row;

/**
 * Impulses that contacts have already applied in a substep. They are put aside while the contacts
 * are solved again within it, since an impulse that has acted is not taken back when bodies part.
 */
public final class EarlierImpulses {

    private static final int[] COLUMNS = {
        PackedContacts.IMPULSE0,
        PackedContacts.IMPULSE1,
        PackedContacts.IMPULSE_T,
        PackedContacts.IMPULSE_R
    };

    private final PackedContacts contacts;

    /** Impulses by row and column, N·s and N·m·s. */
    private double[] impulses = new double[16 * COLUMNS.length];

    public EarlierImpulses(PackedContacts contacts) {
        this.contacts = contacts;
    }

    /** Puts all impulses aside and sets those of the contacts to 0. */
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

    /** Adds the impulses put aside to those that contacts have carried since. */
    public void addBack() {
        int i = 0;
        for (int row = 0; row < contacts.count; row++) {
            for (int column : COLUMNS) {
                contacts.data[row * PackedContacts.STRIDE + column] += impulses[i++];
            }
        }
    }
}
