package rigibo.backend.contact;

import static rigibo.backend.contact.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.Motions.INVERSE_MASS;
import static rigibo.backend.contact.Motions.SPIN;
import static rigibo.backend.contact.Motions.VX;
import static rigibo.backend.contact.Motions.VY;

/**
 * The friction rows |jₜ| ≤ μ·Σjₙ, and the rolling rows |jᵣ| ≤ c·Σjₙ. A contact without friction or
 * rolling resistance is not on the list.
 */
final class FrictionSolver {

    private final Motions motions;
    private final Rows rows;
    private int[] sliding = new int[16];
    private int slidingCount;
    private int[] rolling = new int[16];
    private int rollingCount;

    FrictionSolver(Motions motions, Rows rows) {
        this.motions = motions;
        this.rows = rows;
    }

    /** Lists the rows of the packed island that need it. */
    void prepare() {
        if (sliding.length < rows.count) {
            sliding = new int[2 * rows.count];
            rolling = new int[2 * rows.count];
        }
        slidingCount = 0;
        rollingCount = 0;
        for (int row = 0; row < rows.count; row++) {
            if (rows.data[row * Rows.STRIDE + Rows.FRICTION] > 0) {
                sliding[slidingCount++] = row;
            }
            if (rows.data[row * Rows.STRIDE + Rows.ROLLING] > 0) {
                rolling[rollingCount++] = row;
            }
        }
    }

    /** How many rows a pass solves. */
    int rowCount() {
        return slidingCount + rollingCount;
    }

    /** One pass over both kinds of rows. */
    void solve(int substep) {
        for (int i = 0; i < slidingCount; i++) {
            if (rows.firstSubstep[sliding[i]] <= substep) {
                slide(sliding[i]);
            }
        }
        for (int i = 0; i < rollingCount; i++) {
            if (rows.firstSubstep[rolling[i]] <= substep) {
                roll(rolling[i]);
            }
        }
    }

    private void slide(int row) {
        double[] d = rows.data;
        double[] m = motions.data;
        int at = row * Rows.STRIDE;
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        double nx = d[at + Rows.NX];
        double ny = d[at + Rows.NY];
        double la = d[at + Rows.LEVER_TA];
        double lb = d[at + Rows.LEVER_TB];
        double vt =
                nx * (m[b + VY] - m[a + VY])
                        - ny * (m[b + VX] - m[a + VX])
                        + lb * m[b + SPIN]
                        - la * m[a + SPIN];
        double old = d[at + Rows.IMPULSE_T];
        double most = d[at + Rows.FRICTION] * (d[at + Rows.IMPULSE0] + d[at + Rows.IMPULSE1]);
        double impulse = clamp(old - d[at + Rows.MASS_T] * vt, most);
        d[at + Rows.IMPULSE_T] = impulse;
        applyTangent(m, a, b, nx, ny, impulse - old, la, lb);
    }

    private void roll(int row) {
        double[] d = rows.data;
        double[] m = motions.data;
        int at = row * Rows.STRIDE;
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        double old = d[at + Rows.IMPULSE_R];
        double most = d[at + Rows.ROLLING] * (d[at + Rows.IMPULSE0] + d[at + Rows.IMPULSE1]);
        double impulse = clamp(old - d[at + Rows.INERTIA_R] * (m[b + SPIN] - m[a + SPIN]), most);
        d[at + Rows.IMPULSE_R] = impulse;
        m[a + SPIN] -= m[a + INVERSE_INERTIA] * (impulse - old);
        m[b + SPIN] += m[b + INVERSE_INERTIA] * (impulse - old);
    }

    /** Applies an impulse along the tangent (−ny, nx). */
    static void applyTangent(
            double[] m, int a, int b, double nx, double ny, double j, double la, double lb) {
        double ma = m[a + INVERSE_MASS] * j;
        double mb = m[b + INVERSE_MASS] * j;
        m[a + VX] += ma * ny;
        m[a + VY] -= ma * nx;
        m[a + SPIN] -= m[a + INVERSE_INERTIA] * la * j;
        m[b + VX] -= mb * ny;
        m[b + VY] += mb * nx;
        m[b + SPIN] += m[b + INVERSE_INERTIA] * lb * j;
    }

    private static double clamp(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }
}
