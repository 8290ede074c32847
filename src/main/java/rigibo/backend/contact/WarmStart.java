package rigibo.backend.contact;

import static rigibo.backend.contact.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.Motions.INVERSE_MASS;
import static rigibo.backend.contact.Motions.SPIN;
import static rigibo.backend.contact.Motions.VX;
import static rigibo.backend.contact.Motions.VY;

/** Begins a kick with the impulses of the one before, scaled by the kicks' lengths. */
final class WarmStart {

    private final Motions motions;
    private final Rows rows;

    WarmStart(Motions motions, Rows rows) {
        this.motions = motions;
        this.rows = rows;
    }

    /** Scales every impulse and applies it. */
    void apply(double scale, int substep) {
        for (int row = 0; row < rows.count; row++) {
            if (rows.firstSubstep[row] <= substep) {
                apply(row, scale);
            }
        }
    }

    private void apply(int row, double scale) {
        double[] d = rows.data;
        double[] m = motions.data;
        int at = row * Rows.STRIDE;
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        double nx = d[at + Rows.NX];
        double ny = d[at + Rows.NY];
        double j0 = d[at + Rows.IMPULSE0] *= scale;
        double j1 = d[at + Rows.IMPULSE1] *= scale;
        double jt = d[at + Rows.IMPULSE_T] *= scale;
        double jr = d[at + Rows.IMPULSE_R] *= scale;
        double jx = (j0 + j1) * nx - jt * ny;
        double jy = (j0 + j1) * ny + jt * nx;
        double onA =
                j0 * d[at + Rows.LEVER_A0]
                        + j1 * d[at + Rows.LEVER_A1]
                        + jt * d[at + Rows.LEVER_TA]
                        + jr;
        double onB =
                j0 * d[at + Rows.LEVER_B0]
                        + j1 * d[at + Rows.LEVER_B1]
                        + jt * d[at + Rows.LEVER_TB]
                        + jr;
        m[a + VX] -= m[a + INVERSE_MASS] * jx;
        m[a + VY] -= m[a + INVERSE_MASS] * jy;
        m[a + SPIN] -= m[a + INVERSE_INERTIA] * onA;
        m[b + VX] += m[b + INVERSE_MASS] * jx;
        m[b + VY] += m[b + INVERSE_MASS] * jy;
        m[b + SPIN] += m[b + INVERSE_INERTIA] * onB;
    }
}
