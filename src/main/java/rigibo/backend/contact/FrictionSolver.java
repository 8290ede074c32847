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
    private int[] slidingRows = new int[16];
    private int slidingCount;
    private int[] rollingRows = new int[16];
    private int rollingCount;
    private double largestChange;

    FrictionSolver(Motions motions, Rows rows) {
        this.motions = motions;
        this.rows = rows;
    }

    /** Lists the rows of the packed island that need it. */
    void prepare() {
        if (slidingRows.length < rows.count) {
            slidingRows = new int[rows.pair.length];
            rollingRows = new int[rows.pair.length];
        }
        slidingCount = 0;
        rollingCount = 0;
        for (int row = 0; row < rows.count; row++) {
            if (rows.data[row * Rows.STRIDE + Rows.ROLLING] > 0) {
                rollingRows[rollingCount++] = row;
            } else if (rows.data[row * Rows.STRIDE + Rows.FRICTION] > 0) {
                slidingRows[slidingCount++] = row;
            }
        }
    }

    /** How many rows a pass solves. */
    int rowCount() {
        return slidingCount + rollingCount;
    }

    /** One pass over all kinds of rows; returns the largest change of speed in it, m/s. */
    double solve(int substep) {
        largestChange = 0;
        for (int i = 0; i < slidingCount; i++) {
            if (rows.firstSubstep[slidingRows[i]] <= substep) {
                slide(slidingRows[i]);
            }
        }
        for (int i = 0; i < rollingCount; i++) {
            if (rows.firstSubstep[rollingRows[i]] <= substep) {
                rollWithoutSliding(rollingRows[i]);
            }
        }
        return largestChange;
    }

    /**
     * Rolling brakes the turning, and friction then the moving: where both hold they hold together,
     * or one would keep undoing a part of the other and the wheel would creep back.
     */
    private void rollWithoutSliding(int row) {
        double[] d = rows.data;
        int at = row * Rows.STRIDE;
        double load = d[at + Rows.IMPULSE0] + d[at + Rows.IMPULSE1];
        double mostSlide = d[at + Rows.FRICTION] * load;
        double mostRoll = d[at + Rows.ROLLING] * load;
        double ia = motions.data[rows.bodyA[row] + INVERSE_INERTIA];
        double ib = motions.data[rows.bodyB[row] + INVERSE_INERTIA];
        double slides = mostSlide > 0 ? 1 / d[at + Rows.MASS_T] : 0;
        double both = d[at + Rows.LEVER_TB] * ib + d[at + Rows.LEVER_TA] * ia;
        double determinant = slides * (ia + ib) - both * both;
        if (determinant > 0) {
            double vt = sliding(row);
            double wr = turning(row);
            double tangent = d[at + Rows.IMPULSE_T] + (both * wr - (ia + ib) * vt) / determinant;
            double roll = d[at + Rows.IMPULSE_R] + (both * vt - slides * wr) / determinant;
            if (Math.abs(tangent) <= mostSlide && Math.abs(roll) <= mostRoll) {
                keepTangent(row, tangent);
                keepRoll(row, roll);
                return;
            }
        }
        roll(row);
        if (mostSlide > 0) {
            slide(row);
        }
    }

    private void slide(int row) {
        double[] d = rows.data;
        int at = row * Rows.STRIDE;
        double most = d[at + Rows.FRICTION] * (d[at + Rows.IMPULSE0] + d[at + Rows.IMPULSE1]);
        double wanted = d[at + Rows.IMPULSE_T] - d[at + Rows.MASS_T] * sliding(row);
        keepTangent(row, clamp(wanted / (1 + Rows.COMPLIANCE), most));
    }

    /** Speed in m/s at which B slides along the tangent on A, against surfaces that run. */
    private double sliding(int row) {
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

    private void keepTangent(int row, double impulse) {
        double[] d = rows.data;
        int at = row * Rows.STRIDE;
        double change = impulse - d[at + Rows.IMPULSE_T];
        d[at + Rows.IMPULSE_T] = impulse;
        largestChange = Math.max(largestChange, Math.abs(change) / d[at + Rows.MASS_T]);
        applyTangent(
                motions.data,
                rows.bodyA[row],
                rows.bodyB[row],
                d[at + Rows.NX],
                d[at + Rows.NY],
                change,
                d[at + Rows.LEVER_TA],
                d[at + Rows.LEVER_TB]);
    }

    private void roll(int row) {
        double[] d = rows.data;
        int at = row * Rows.STRIDE;
        double most = d[at + Rows.ROLLING] * (d[at + Rows.IMPULSE0] + d[at + Rows.IMPULSE1]);
        double wanted = d[at + Rows.IMPULSE_R] - d[at + Rows.INERTIA_R] * turning(row);
        keepRoll(row, clamp(wanted, most));
    }

    /** Angular speed of B against A, rad/s. */
    private double turning(int row) {
        return motions.data[rows.bodyB[row] + SPIN] - motions.data[rows.bodyA[row] + SPIN];
    }

    private void keepRoll(int row, double impulse) {
        double[] d = rows.data;
        double[] m = motions.data;
        int at = row * Rows.STRIDE;
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        double change = impulse - d[at + Rows.IMPULSE_R];
        double reach = Math.abs(d[at + Rows.LEVER_TB] - d[at + Rows.LEVER_TA]);
        d[at + Rows.IMPULSE_R] = impulse;
        largestChange = Math.max(largestChange, reach * Math.abs(change) / d[at + Rows.INERTIA_R]);
        m[a + SPIN] -= m[a + INVERSE_INERTIA] * change;
        m[b + SPIN] += m[b + INVERSE_INERTIA] * change;
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
