package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

/**
 * The rows of a packed island, each written out over the velocities of all bodies: two points, the
 * tangent and rolling of every contact. Impulses j change velocities by M⁻¹·Jᵀ·j.
 */
public final class DenseRows {

    public static final int KINDS = 4;
    public static final int TANGENT = 2;
    public static final int ROLLING = 3;

    private static final int[] IMPULSES = {
        PackedContacts.IMPULSE0,
        PackedContacts.IMPULSE1,
        PackedContacts.IMPULSE_T,
        PackedContacts.IMPULSE_R
    };

    private final Motions motions;
    private final PackedContacts contacts;

    private double[] velocitiesBefore;
    private double[] impulsesBefore;

    public DenseRows(PackedIsland island) {
        motions = island.motions;
        contacts = island.contacts;
    }

    /** Derivatives of a row: x, y and turn of every entry. */
    public double[] row(int contact, int kind) {
        double[] row = new double[3 * motions.count];
        add(row, contacts.bodyA[contact], contact, kind, -1);
        add(row, contacts.bodyB[contact], contact, kind, 1);
        return row;
    }

    private void add(double[] row, int body, int contact, int kind, double sign) {
        double[] d = contacts.data;
        int at = contact * PackedContacts.STRIDE;
        int to = 3 * (body / Motions.STRIDE);
        int lever = kind == TANGENT ? PackedContacts.LEVER_TA : PackedContacts.LEVER_A0 + 2 * kind;
        double nx = d[at + PackedContacts.NX];
        double ny = d[at + PackedContacts.NY];
        double turn = kind == ROLLING ? 1 : d[at + lever + (sign > 0 ? 1 : 0)];
        row[to] += sign * (kind == ROLLING ? 0 : kind == TANGENT ? -ny : nx);
        row[to + 1] += sign * (kind == ROLLING ? 0 : kind == TANGENT ? nx : ny);
        row[to + 2] += sign * turn;
    }

    /** Present velocities: x, y and spin of every entry. */
    public double[] velocities() {
        return columns(Motions.VX);
    }

    /** Present displacements: x, y and turn of every entry. */
    public double[] displacements() {
        return columns(Motions.DX);
    }

    private double[] columns(int first) {
        double[] all = new double[3 * motions.count];
        for (int i = 0; i < all.length; i++) {
            all[i] = motions.data[i / 3 * Motions.STRIDE + first + i % 3];
        }
        return all;
    }

    /** J·v of a row. */
    public double along(int contact, int kind, double[] velocities) {
        double[] row = row(contact, kind);
        double sum = 0;
        for (int i = 0; i < row.length; i++) {
            sum += row[i] * velocities[i];
        }
        return sum;
    }

    /** Present speed of a row. */
    public double speed(int contact, int kind) {
        return along(contact, kind, velocities());
    }

    /** Present impulses, by contact and kind. */
    public double[] impulses() {
        double[] all = new double[KINDS * contacts.count];
        for (int i = 0; i < all.length; i++) {
            all[i] = contacts.data[i / KINDS * PackedContacts.STRIDE + IMPULSES[i % KINDS]];
        }
        return all;
    }

    /** M⁻¹·Jᵀ·j of impulses by contact and kind. */
    public double[] change(double[] impulses) {
        double[] change = new double[3 * motions.count];
        for (int k = 0; k < impulses.length; k++) {
            double[] row = row(k / KINDS, k % KINDS);
            for (int i = 0; i < row.length; i++) {
                int mass = i % 3 == 2 ? Motions.INVERSE_INERTIA : Motions.INVERSE_MASS;
                change[i] += motions.data[i / 3 * Motions.STRIDE + mass] * row[i] * impulses[k];
            }
        }
        return change;
    }

    /** Speed of one row by a unit impulse of another: an entry of J·M⁻¹·Jᵀ. */
    public double response(int contact, int kind, int otherContact, int otherKind) {
        double[] unit = new double[KINDS * contacts.count];
        unit[KINDS * otherContact + otherKind] = 1;
        return along(contact, kind, change(unit));
    }

    /** ½·vᵀ·M·v of all movable bodies, J. */
    public double energy() {
        double[] v = velocities();
        double sum = 0;
        for (int i = 3; i < v.length; i++) {
            int mass = i % 3 == 2 ? Motions.INVERSE_INERTIA : Motions.INVERSE_MASS;
            double inverse = motions.data[i / 3 * Motions.STRIDE + mass];
            sum += inverse > 0 ? v[i] * v[i] / (2 * inverse) : 0;
        }
        return sum;
    }

    /** Adds the velocities that the present impulses give. */
    public void applyImpulses() {
        double[] change = change(impulses());
        for (int i = 0; i < change.length; i++) {
            motions.data[i / 3 * Motions.STRIDE + Motions.VX + i % 3] += change[i];
        }
    }

    /** Records velocities and impulses. */
    public void begin() {
        velocitiesBefore = velocities();
        impulsesBefore = impulses();
    }

    /** Asserts that since the record velocities have changed by the changes of impulses alone. */
    public void assertImpulsesTellAll(double tolerance) {
        double[] impulses = impulses();
        for (int k = 0; k < impulses.length; k++) {
            impulses[k] -= impulsesBefore[k];
        }
        double[] change = change(impulses);
        double[] now = velocities();
        for (int i = 3; i < now.length; i++) {
            assertThat(now[i] - velocitiesBefore[i]).isCloseTo(change[i], within(tolerance));
        }
    }
}
