package rigibo.backend.contact;

import static rigibo.backend.contact.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.Motions.INVERSE_MASS;
import static rigibo.backend.contact.Motions.SPIN;
import static rigibo.backend.contact.Motions.VX;
import static rigibo.backend.contact.Motions.VY;

import rigibo.backend.storage.Pairs;

/** The friction rows |jₜ| ≤ μ·Σjₙ. A contact without friction is not on the list. */
final class FrictionSolver implements Rubbing {

    private final Motions motions;
    private final Rows rows;
    private final Pairs pairs;
    private int[] rubbing = new int[16];
    private int count;

    FrictionSolver(Motions motions, Rows rows, Pairs pairs) {
        this.motions = motions;
        this.rows = rows;
        this.pairs = pairs;
    }

    @Override
    public void begin(double firstKick) {
        if (rubbing.length < rows.count) {
            rubbing = new int[rows.pair.length];
        }
        count = 0;
        for (int row = 0; row < rows.count; row++) {
            double friction = pairs.friction[rows.pair[row]];
            if (friction > 0) {
                int at = row * Rows.STRIDE;
                rows.data[at + Rows.FRICTION] = friction;
                rows.data[at + Rows.IMPULSE_T] = pairs.heldFriction(rows.pair[row]) * firstKick;
                rubbing[count++] = row;
            }
        }
        refresh();
    }

    @Override
    public void refresh() {
        for (int i = 0; i < count; i++) {
            int row = rubbing[i];
            int at = row * Rows.STRIDE;
            double ta = rows.data[at + Rows.LEVER_TA];
            double tb = rows.data[at + Rows.LEVER_TB];
            rows.data[at + Rows.MASS_T] =
                    1 / motions.response(rows.bodyA[row], rows.bodyB[row], ta, tb, ta, tb);
        }
    }

    @Override
    public int rowCount() {
        return count;
    }

    @Override
    public void store(double h) {
        for (int i = 0; i < count; i++) {
            double impulse = rows.data[rubbing[i] * Rows.STRIDE + Rows.IMPULSE_T];
            pairs.frictionForce[rows.pair[rubbing[i]]] = impulse * (2 / h);
        }
    }

    /** Lets a contact slide no more than its load allows. */
    void slide(int row) {
        keepTangent(row, impulseWithinLoad(row));
    }

    private double impulseWithinLoad(int row) {
        double[] d = rows.data;
        int at = row * Rows.STRIDE;
        double most = d[at + Rows.FRICTION] * (d[at + Rows.IMPULSE0] + d[at + Rows.IMPULSE1]);
        double wanted = d[at + Rows.IMPULSE_T] - d[at + Rows.MASS_T] * slidingSpeed(row);
        return clamp(wanted / (1 + Rows.COMPLIANCE), most);
    }

    /** Speed in m/s at which B slides along the tangent on A, against surfaces that run. */
    double slidingSpeed(int row) {
        double[] d = rows.data;
        double[] m = motions.data;
        int at = row * Rows.STRIDE;
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        return d[at + Rows.NX] * (m[b + VY] - m[a + VY])
                - d[at + Rows.NY] * (m[b + VX] - m[a + VX])
                + d[at + Rows.LEVER_TB] * m[b + SPIN]
                - d[at + Rows.LEVER_TA] * m[a + SPIN]
                - rows.surface[row];
    }

    /** Takes an impulse along the tangent in place of the one there was, N·s. */
    void keepTangent(int row, double impulse) {
        double[] d = rows.data;
        int at = row * Rows.STRIDE;
        double change = impulse - d[at + Rows.IMPULSE_T];
        d[at + Rows.IMPULSE_T] = impulse;
        apply(row, change);
    }

    /** Applies an impulse along the tangent (−ny, nx), N·s. */
    private void apply(int row, double impulse) {
        double[] d = rows.data;
        double[] m = motions.data;
        int at = row * Rows.STRIDE;
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        double ma = m[a + INVERSE_MASS] * impulse;
        double mb = m[b + INVERSE_MASS] * impulse;
        m[a + VX] += ma * d[at + Rows.NY];
        m[a + VY] -= ma * d[at + Rows.NX];
        m[a + SPIN] -= m[a + INVERSE_INERTIA] * d[at + Rows.LEVER_TA] * impulse;
        m[b + VX] -= mb * d[at + Rows.NY];
        m[b + VY] += mb * d[at + Rows.NX];
        m[b + SPIN] += m[b + INVERSE_INERTIA] * d[at + Rows.LEVER_TB] * impulse;
    }

    /** The impulse nearest to one that is wanted, of those up to a bound either way. */
    static double clamp(double value, double most) {
        // Math.max and Math.min take care of signed zeros, which takes them thrice as long.
        return value > most ? most : value < -most ? -most : value;
    }
}
