package rigibo.backend.contact.row;

import java.util.Arrays;
import java.util.SplittableRandom;

/** An island packed by hand: each body lies on another one or on the ground. */
public final class PackedIsland {

    public final Motions motions = new Motions(true);
    public final PackedContacts contacts = new PackedContacts();

    /** Empties it and makes room for a number of bodies. */
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

    /** The number in a column of a contact. */
    public double of(int row, int column) {
        return contacts.data[row * PackedContacts.STRIDE + column];
    }

    /** Sets the number in a column of a contact. */
    public void set(int row, int column, double value) {
        contacts.data[row * PackedContacts.STRIDE + column] = value;
    }

    /** Adds a body with a radius of one metre. */
    public void body(int entry, double inverseMass, double inverseInertia) {
        motions.data[entry * Motions.STRIDE + Motions.INVERSE_MASS] = inverseMass;
        motions.data[entry * Motions.STRIDE + Motions.INVERSE_INERTIA] = inverseInertia;
        motions.reach[entry] = 1;
    }

    /**
     * Adds a contact with the ground, with points to the left and to the right of the centre, m.
     */
    public int onGround(int entry, double left, double right) {
        return contact(0, entry, left, right);
    }

    /** Adds a contact of B on A, with points to the left and to the right of both centres, m. */
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
        // For bodies that do not turn both points are one.
        contacts.points[row] = determinant > 0 ? 2 : 1;
        d[at + PackedContacts.M00] = determinant > 0 ? k11 / determinant : 1 / k00;
        d[at + PackedContacts.M01] = -k01 / determinant;
        d[at + PackedContacts.M11] = k00 / determinant;
        return row;
    }

    /** Adds bodies of any mass and inertia, with any velocities. */
    public void bodies(SplittableRandom random, int count) {
        begin(count);
        for (int entry = 1; entry <= count; entry++) {
            body(entry, random.nextDouble(0.2, 5), random.nextDouble(0.2, 5));
            for (int column = Motions.VX; column <= Motions.SPIN; column++) {
                motions.data[entry * Motions.STRIDE + column] = random.nextDouble(-1, 1);
            }
        }
    }

    /** Adds a contact with any normal and levers, whose two points are distinct. */
    public int contact(SplittableRandom random, int entryA, int entryB) {
        int row = contact(entryA, entryB, random.nextDouble(0.2, 1), random.nextDouble(0.2, 1));
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        double angle = random.nextDouble(-3, 3);
        d[at + PackedContacts.NX] = Math.cos(angle);
        d[at + PackedContacts.NY] = Math.sin(angle);
        // Other levers on A, so that A and B turn differently.
        double shift = random.nextDouble(-0.3, 0.3);
        d[at + PackedContacts.LEVER_A0] += shift;
        d[at + PackedContacts.LEVER_A1] += shift;
        d[at + PackedContacts.LEVER_TA] = random.nextDouble(-1, 1);
        d[at + PackedContacts.LEVER_TB] = random.nextDouble(-1, 1);
        writeMasses(row);
        return row;
    }

    /** Sets the speed of a contact's surface, m/s. */
    public void run(int row, double speed) {
        contacts.surface[row] = speed;
        contacts.running[row] = speed;
        contacts.isAnyRunning = true;
    }

    /** Writes the responses of a contact's rows with its compliance, and their inverses. */
    public void writeMasses(int row) {
        int at = row * PackedContacts.STRIDE;
        double[] d = contacts.data;
        double give = d[at + PackedContacts.GIVE];
        double k00 = give + response(row, PackedContacts.LEVER_A0, PackedContacts.LEVER_A0);
        double k01 = response(row, PackedContacts.LEVER_A0, PackedContacts.LEVER_A1);
        double k11 = give + response(row, PackedContacts.LEVER_A1, PackedContacts.LEVER_A1);
        double determinant = k00 * k11 - k01 * k01;
        d[at + PackedContacts.K00] = k00;
        d[at + PackedContacts.K01] = k01;
        d[at + PackedContacts.K11] = k11;
        d[at + PackedContacts.M00] = k11 / determinant;
        d[at + PackedContacts.M01] = -k01 / determinant;
        d[at + PackedContacts.M11] = k00 / determinant;
        d[at + PackedContacts.MASS_T] =
                1 / response(row, PackedContacts.LEVER_TA, PackedContacts.LEVER_TA);
    }

    private double response(int row, int lever, int other) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        return motions.response(
                contacts.bodyA[row],
                contacts.bodyB[row],
                d[at + lever],
                d[at + lever + 1],
                d[at + other],
                d[at + other + 1]);
    }
}
