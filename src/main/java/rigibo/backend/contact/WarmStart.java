package rigibo.backend.contact;

import static rigibo.backend.contact.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.Motions.INVERSE_MASS;
import static rigibo.backend.contact.Motions.SPIN;
import static rigibo.backend.contact.Motions.VX;
import static rigibo.backend.contact.Motions.VY;

/**
 * Begins a kick with the impulses of the one before, scaled by the kicks' lengths. What a contact
 * carries it carries for two kicks at least; what stopped a fall it did once, and given again it
 * would throw the body back. So a kick begins with no more than a multiple of what a contact
 * carried in the one before the last.
 */
final class WarmStart {

    private final Motions motions;
    private final Rows rows;

    WarmStart(Motions motions, Rows rows) {
        this.motions = motions;
        this.rows = rows;
    }

    /** Takes the packed island's impulses for those of the last two kicks. */
    void prepare() {
        for (int at = 0; at < rows.count * Rows.STRIDE; at += Rows.STRIDE) {
            keep(at);
        }
    }

    /** Leaves out of every impulse what it has more than a multiple of the one before. */
    void leaveOutBlows(double growth) {
        double[] d = rows.data;
        for (int at = 0; at < rows.count * Rows.STRIDE; at += Rows.STRIDE) {
            double j0 = Math.min(d[at + Rows.IMPULSE0], growth * d[at + Rows.BEFORE0]);
            double j1 = Math.min(d[at + Rows.IMPULSE1], growth * d[at + Rows.BEFORE1]);
            double both = d[at + Rows.IMPULSE0] + d[at + Rows.IMPULSE1];
            double share = both > 0 ? (j0 + j1) / both : 0;
            keep(at);
            d[at + Rows.IMPULSE0] = j0;
            d[at + Rows.IMPULSE1] = j1;
            d[at + Rows.IMPULSE_T] *= share;
            d[at + Rows.IMPULSE_R] *= share;
        }
    }

    private void keep(int at) {
        rows.data[at + Rows.BEFORE0] = rows.data[at + Rows.IMPULSE0];
        rows.data[at + Rows.BEFORE1] = rows.data[at + Rows.IMPULSE1];
    }

    /** Scales those of the kick before as {@link #apply} does the present ones. */
    void scaleBefore(double scale, int substep) {
        for (int row = 0; row < rows.count; row++) {
            if (rows.firstSubstep[row] <= substep) {
                rows.data[row * Rows.STRIDE + Rows.BEFORE0] *= scale;
                rows.data[row * Rows.STRIDE + Rows.BEFORE1] *= scale;
            }
        }
    }

    /** Scales every impulse and applies it. */
    void apply(double scale, int substep) {
        for (int row = 0; row < rows.count; row++) {
            if (rows.firstSubstep[row] <= substep) {
                int at = row * Rows.STRIDE;
                rows.data[at + Rows.IMPULSE0] *= scale;
                rows.data[at + Rows.IMPULSE1] *= scale;
                rows.data[at + Rows.IMPULSE_T] *= scale;
                rows.data[at + Rows.IMPULSE_R] *= scale;
            }
        }
        add(1, substep);
    }

    /** Gives bodies a multiple of all impulses; −1 takes back what they were given. */
    void add(double multiple, int substep) {
        for (int row = 0; row < rows.count; row++) {
            if (rows.firstSubstep[row] <= substep) {
                addOf(row, multiple);
            }
        }
    }

    private void addOf(int row, double multiple) {
        double[] d = rows.data;
        double[] m = motions.data;
        int at = row * Rows.STRIDE;
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        double nx = d[at + Rows.NX];
        double ny = d[at + Rows.NY];
        double j0 = multiple * d[at + Rows.IMPULSE0];
        double j1 = multiple * d[at + Rows.IMPULSE1];
        double jt = multiple * d[at + Rows.IMPULSE_T];
        double jx = (j0 + j1) * nx - jt * ny;
        double jy = (j0 + j1) * ny + jt * nx;
        m[a + VX] -= m[a + INVERSE_MASS] * jx;
        m[a + VY] -= m[a + INVERSE_MASS] * jy;
        m[b + VX] += m[b + INVERSE_MASS] * jx;
        m[b + VY] += m[b + INVERSE_MASS] * jy;
        if (motions.turns) {
            turn(m, d, at, a, b, j0, j1, jt, multiple * d[at + Rows.IMPULSE_R]);
        }
    }

    private static void turn(
            double[] m,
            double[] d,
            int at,
            int a,
            int b,
            double j0,
            double j1,
            double jt,
            double jr) {
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
        m[a + SPIN] -= m[a + INVERSE_INERTIA] * onA;
        m[b + SPIN] += m[b + INVERSE_INERTIA] * onB;
    }
}
