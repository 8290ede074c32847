package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.SPIN;
import static rigibo.backend.contact.row.Motions.VX;
import static rigibo.backend.contact.row.Motions.VY;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Pairs;

/** Solves the friction rows, |jₜ| ≤ μ·Σjₙ, of all contacts with friction. */
public final class FrictionSolver implements Rubbing {

    private final Motions motions;
    private final PackedContacts contacts;
    private final Pairs pairs;
    private int[] rubbing = new int[16];
    private int count;

    public FrictionSolver(Motions motions, PackedContacts contacts, Pairs pairs) {
        this.motions = motions;
        this.contacts = contacts;
        this.pairs = pairs;
    }

    @Override
    public void begin(double firstKick) {
        if (rubbing.length < contacts.count) {
            rubbing = new int[contacts.pair.length];
        }
        count = 0;
        for (int row = 0; row < contacts.count; row++) {
            double friction = pairs.friction[contacts.pair[row]];
            if (friction > 0) {
                int at = row * PackedContacts.STRIDE;
                contacts.data[at + PackedContacts.FRICTION] = friction;
                contacts.data[at + PackedContacts.IMPULSE_T] =
                        pairs.heldFriction(contacts.pair[row]) * firstKick;
                rubbing[count++] = row;
            }
        }
        refresh();
    }

    @Override
    public void refresh() {
        for (int i = 0; i < count; i++) {
            int row = rubbing[i];
            int at = row * PackedContacts.STRIDE;
            double ta = contacts.data[at + PackedContacts.LEVER_TA];
            double tb = contacts.data[at + PackedContacts.LEVER_TB];
            contacts.data[at + PackedContacts.MASS_T] =
                    1 / motions.response(contacts.bodyA[row], contacts.bodyB[row], ta, tb, ta, tb);
        }
    }

    @Override
    public int rowCount() {
        return count;
    }

    @Override
    public void store(double h) {
        for (int i = 0; i < count; i++) {
            double impulse =
                    contacts.data[rubbing[i] * PackedContacts.STRIDE + PackedContacts.IMPULSE_T];
            pairs.frictionForce[contacts.pair[rubbing[i]]] = impulse * (2 / h);
        }
    }

    /** Solves the friction of a contact within the bound of its load. */
    void slide(int row) {
        keepTangent(row, impulseWithinLoad(row));
    }

    private double impulseWithinLoad(int row) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        double most =
                d[at + PackedContacts.FRICTION]
                        * (d[at + PackedContacts.IMPULSE0] + d[at + PackedContacts.IMPULSE1]);
        double wanted =
                d[at + PackedContacts.IMPULSE_T]
                        - d[at + PackedContacts.MASS_T] * slidingSpeed(row);
        return clamp(wanted / (1 + PackedContacts.COMPLIANCE), most);
    }

    /** Sliding speed of B on A along the tangent, relative to running surfaces, m/s. */
    double slidingSpeed(int row) {
        double[] d = contacts.data;
        double[] m = motions.data;
        int at = row * PackedContacts.STRIDE;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        return d[at + PackedContacts.NX] * (m[b + VY] - m[a + VY])
                - d[at + PackedContacts.NY] * (m[b + VX] - m[a + VX])
                + d[at + PackedContacts.LEVER_TB] * m[b + SPIN]
                - d[at + PackedContacts.LEVER_TA] * m[a + SPIN]
                - contacts.surface[row];
    }

    /** Replaces the impulse along the tangent, N·s. */
    void keepTangent(int row, double impulse) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        double change = impulse - d[at + PackedContacts.IMPULSE_T];
        d[at + PackedContacts.IMPULSE_T] = impulse;
        apply(row, change);
    }

    /** Applies an impulse along the tangent (−ny, nx), N·s. */
    private void apply(int row, double impulse) {
        double[] d = contacts.data;
        double[] m = motions.data;
        int at = row * PackedContacts.STRIDE;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double ma = m[a + INVERSE_MASS] * impulse;
        double mb = m[b + INVERSE_MASS] * impulse;
        m[a + VX] += ma * d[at + PackedContacts.NY];
        m[a + VY] -= ma * d[at + PackedContacts.NX];
        m[a + SPIN] -= m[a + INVERSE_INERTIA] * d[at + PackedContacts.LEVER_TA] * impulse;
        m[b + VX] -= mb * d[at + PackedContacts.NY];
        m[b + VY] += mb * d[at + PackedContacts.NX];
        m[b + SPIN] += m[b + INVERSE_INERTIA] * d[at + PackedContacts.LEVER_TB] * impulse;
    }

    /** Clamps a wanted impulse to ± a bound. */
    static double clamp(double value, double most) {
        // Math.max and Math.min distinguish signed zeros and so take three times as long.
        return value > most ? most : value < -most ? -most : value;
    }
}
