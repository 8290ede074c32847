package rigibo.backend.contact.row;

import java.util.Arrays;

/** An island that is packed by hand: bodies of which each lies on another, or on the ground. */
public final class PackedIsland {

    public final Motions motions = new Motions(true);
    public final PackedContacts contacts = new PackedContacts();

    /** Empties it, and makes room for so many bodies. */
    public void begin(int bodies) {
        contacts.clear(bodies);
        motions.count = bodies + 1;
        if (motions.slots.length < motions.count) {
            motions.slots = new int[motions.count];
            motions.reach = new double[motions.count];
            motions.data = new double[motions.count * Motions.STRIDE];
        }
        Arrays.fill(motions.data, 0);
        contacts.groundStart = 0;
    }

    /** A body whose outline reaches one metre. */
    public void body(int entry, double inverseMass, double inverseInertia) {
        motions.data[entry * Motions.STRIDE + Motions.INVERSE_MASS] = inverseMass;
        motions.data[entry * Motions.STRIDE + Motions.INVERSE_INERTIA] = inverseInertia;
        motions.reach[entry] = 1;
    }

    /** On the ground, with points so far to the left and to the right of its centre, m. */
    public int onGround(int entry, double left, double right) {
        return contact(0, entry, left, right);
    }

    /** B on A, with points so far to the left and to the right of both centres, m. */
    public int contact(int entryA, int entryB, double left, double right) {
        int row = contacts.add();
        int at = row * PackedContacts.STRIDE;
        contacts.bodyA[row] = entryA * Motions.STRIDE;
        contacts.bodyB[row] = entryB * Motions.STRIDE;
        double[] d = contacts.data;
        d[at + PackedContacts.NY] = 1;
        d[at + PackedContacts.WIDTH] = 1;
        d[at + PackedContacts.LEVER_A0] = -left;
        d[at + PackedContacts.LEVER_B0] = -left;
        d[at + PackedContacts.LEVER_A1] = right;
        d[at + PackedContacts.LEVER_B1] = right;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double k00 = motions.response(a, b, -left, -left, -left, -left);
        double k01 = motions.response(a, b, -left, -left, right, right);
        double k11 = motions.response(a, b, right, right, right, right);
        double determinant = k00 * k11 - k01 * k01;
        d[at + PackedContacts.K00] = k00;
        d[at + PackedContacts.K01] = k01;
        d[at + PackedContacts.K11] = k11;
        // Of bodies that do not turn both points are one.
        contacts.points[row] = determinant > 0 ? 2 : 1;
        d[at + PackedContacts.M00] = determinant > 0 ? k11 / determinant : 1 / k00;
        d[at + PackedContacts.M01] = -k01 / determinant;
        d[at + PackedContacts.M11] = k00 / determinant;
        return row;
    }
}
