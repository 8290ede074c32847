package rigibo.backend.contact;

import static rigibo.backend.contact.Motions.DX;
import static rigibo.backend.contact.Motions.DY;
import static rigibo.backend.contact.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.Motions.INVERSE_MASS;
import static rigibo.backend.contact.Motions.SPIN;
import static rigibo.backend.contact.Motions.TURN;
import static rigibo.backend.contact.Motions.VX;
import static rigibo.backend.contact.Motions.VY;

/**
 * The normal rows: points do not close faster than their gap allows within a substep, and push only
 * (j ≥ 0 ⊥ v + gap/h ≥ 0). Two points of one contact are one small complementarity problem, solved
 * by trying its four cases, so that a flat box answers both corners at once and does not rock.
 */
final class NormalSolver {

    private static final SoftPush RIGID = SoftPush.none();

    private final Motions motions;
    private final Rows rows;
    private final boolean isBlock;
    private double largestChange;

    NormalSolver(Motions motions, Rows rows, boolean isBlock) {
        this.motions = motions;
        this.rows = rows;
        this.isBlock = isBlock;
    }

    /**
     * One pass over all rows, in their order, for a substep of h seconds.
     *
     * @return the largest change of speed in it, m/s
     */
    double forth(double h, int substep) {
        largestChange = 0;
        for (int row = 0; row < rows.count; row++) {
            if (rows.firstSubstep[row] <= substep) {
                solve(row, 1 / h, RIGID);
            }
        }
        return largestChange;
    }

    /** The same, but overlapping points give way and are pushed apart, as by a damped spring. */
    void push(double h, double kick, int substep, SoftPush soft) {
        soft.begin(h, kick);
        for (int row = 0; row < rows.count; row++) {
            if (rows.firstSubstep[row] <= substep) {
                solve(row, 1 / h, soft);
            }
        }
    }

    /** One pass against their order: what the first pass missed below, this one carries up. */
    double back(double h, int substep) {
        largestChange = 0;
        for (int row = rows.groundStart - 1; row >= 0; row--) {
            if (rows.firstSubstep[row] <= substep) {
                solve(row, 1 / h, RIGID);
            }
        }
        for (int row = rows.groundStart; row < rows.count; row++) {
            if (rows.firstSubstep[row] <= substep) {
                solve(row, 1 / h, RIGID);
            }
        }
        return largestChange;
    }

    /**
     * One pass back over a pile that is not solved whole, together with what its contacts do along
     * their tangents, each of which goes first: a contact is read from memory once, not twice. The
     * last such pass of a kick adds its impulses up.
     */
    void relax(double h, int substep, Rubbing rubbing, boolean isLast) {
        for (int row = rows.groundStart - 1; row >= 0; row--) {
            relax(row, h, substep, rubbing, isLast);
        }
        for (int row = rows.groundStart; row < rows.count; row++) {
            relax(row, h, substep, rubbing, isLast);
        }
    }

    private void relax(int row, double h, int substep, Rubbing rubbing, boolean isLast) {
        if (rows.firstSubstep[row] <= substep) {
            rubbing.rub(row);
            solve(row, 1 / h, RIGID);
        }
        if (isLast) {
            rows.addUpImpulses(row, 1);
        }
    }

    private void solve(int row, double perSubstep, SoftPush soft) {
        if (motions.turns) {
            solveTurning(row, perSubstep, soft);
        } else {
            solveStraight(row, perSubstep, soft);
        }
    }

    /** Where nothing turns, two points of a contact are as good as one. */
    private void solveStraight(int row, double perSubstep, SoftPush soft) {
        double[] d = rows.data;
        double[] m = motions.data;
        int at = row * Rows.STRIDE;
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        double nx = d[at + Rows.NX];
        double ny = d[at + Rows.NY];
        double v = nx * (m[b + VX] - m[a + VX]) + ny * (m[b + VY] - m[a + VY]);
        double gap =
                d[at + Rows.GAP0] + (nx * (m[b + DX] - m[a + DX]) + ny * (m[b + DY] - m[a + DY]));
        double old = d[at + Rows.IMPULSE0];
        double bias = soft.bias(gap, d[at + Rows.WIDTH], perSubstep);
        double w = v + bias + d[at + Rows.GIVE] * old;
        double rigid = push(old - w * d[at + Rows.M00]);
        double impulse = gap > 0 ? rigid : soft.soften(rigid, d[at + Rows.LOAD0]);
        d[at + Rows.IMPULSE0] = impulse;
        noteChange(impulse - old, d[at + Rows.K00]);
        double ma = m[a + INVERSE_MASS] * (impulse - old);
        double mb = m[b + INVERSE_MASS] * (impulse - old);
        m[a + VX] -= ma * nx;
        m[a + VY] -= ma * ny;
        m[b + VX] += mb * nx;
        m[b + VY] += mb * ny;
    }

    private void solveTurning(int row, double perSubstep, SoftPush soft) {
        double[] d = rows.data;
        double[] m = motions.data;
        int at = row * Rows.STRIDE;
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        double nx = d[at + Rows.NX];
        double ny = d[at + Rows.NY];
        double vn =
                nx * (m[b + VX] - m[a + VX]) + ny * (m[b + VY] - m[a + VY]) - d[at + Rows.NEARING];
        double dn = nx * (m[b + DX] - m[a + DX]) + ny * (m[b + DY] - m[a + DY]);
        double la0 = d[at + Rows.LEVER_A0];
        double lb0 = d[at + Rows.LEVER_B0];
        double v0 = vn + lb0 * m[b + SPIN] - la0 * m[a + SPIN];
        double gap0 = d[at + Rows.GAP0] + dn + lb0 * m[b + TURN] - la0 * m[a + TURN];
        double old0 = d[at + Rows.IMPULSE0];
        double give = d[at + Rows.GIVE];
        double w0 = v0 + soft.bias(gap0, d[at + Rows.WIDTH], perSubstep) + give * old0;
        if (rows.points[row] == 1) {
            double rigid = push(old0 - w0 * d[at + Rows.M00]);
            double impulse = gap0 > 0 ? rigid : soft.soften(rigid, d[at + Rows.LOAD0]);
            d[at + Rows.IMPULSE0] = impulse;
            noteChange(impulse - old0, d[at + Rows.K00]);
            apply(m, a, b, nx, ny, impulse - old0, la0 * (impulse - old0), lb0 * (impulse - old0));
            return;
        }
        double la1 = d[at + Rows.LEVER_A1];
        double lb1 = d[at + Rows.LEVER_B1];
        double gap1 = d[at + Rows.GAP1] + dn + lb1 * m[b + TURN] - la1 * m[a + TURN];
        double old1 = d[at + Rows.IMPULSE1];
        double v1 = vn + lb1 * m[b + SPIN] - la1 * m[a + SPIN];
        double w1 = v1 + soft.bias(gap1, d[at + Rows.WIDTH], perSubstep) + give * old1;
        solvePair(d, at, w0, w1);
        if (gap0 <= 0 && gap1 <= 0) {
            d[at + Rows.IMPULSE0] = soft.soften(d[at + Rows.IMPULSE0], d[at + Rows.LOAD0]);
            d[at + Rows.IMPULSE1] = soft.soften(d[at + Rows.IMPULSE1], d[at + Rows.LOAD1]);
        }
        double j0 = d[at + Rows.IMPULSE0] - old0;
        double j1 = d[at + Rows.IMPULSE1] - old1;
        noteChange(j0, d[at + Rows.K00]);
        noteChange(j1, d[at + Rows.K11]);
        apply(m, a, b, nx, ny, j0 + j1, la0 * j0 + la1 * j1, lb0 * j0 + lb1 * j1);
    }

    /** Writes the impulses that bring w = v + gap/h to w ≥ 0, j ≥ 0, w·j = 0. */
    private void solvePair(double[] d, int at, double w0, double w1) {
        double old0 = d[at + Rows.IMPULSE0];
        double old1 = d[at + Rows.IMPULSE1];
        if (!isBlock) {
            double j0 = push(old0 - w0 / d[at + Rows.K00]);
            double after1 = w1 + d[at + Rows.K01] * (j0 - old0);
            keep(d, at, j0, push(old1 - after1 / d[at + Rows.K11]));
            return;
        }
        double both0 = old0 - d[at + Rows.M00] * w0 - d[at + Rows.M01] * w1;
        double both1 = old1 - d[at + Rows.M01] * w0 - d[at + Rows.M11] * w1;
        if (both0 >= 0 && both1 >= 0) {
            keep(d, at, both0, both1);
            return;
        }
        double k00 = d[at + Rows.K00];
        double k01 = d[at + Rows.K01];
        double k11 = d[at + Rows.K11];
        // What w would be without any impulse of these two rows.
        double free0 = w0 - k00 * old0 - k01 * old1;
        double free1 = w1 - k01 * old0 - k11 * old1;
        double only0 = -free0 / k00;
        double only1 = -free1 / k11;
        if (free0 >= 0 && free1 >= 0) {
            keep(d, at, 0, 0);
        } else if (free1 + k01 * push(only0) >= free0 + k01 * push(only1)) {
            // Of the two cases that are left round-off may deny both: then the nearer one is true.
            keep(d, at, push(only0), 0);
        } else {
            keep(d, at, 0, push(only1));
        }
    }

    private void noteChange(double impulse, double response) {
        double change = Math.abs(impulse) * response;
        if (change > largestChange) {
            largestChange = change;
        }
    }

    /** An impulse that only pushes; Math.max would take care of signed zeros, thrice as long. */
    private static double push(double wanted) {
        return wanted > 0 ? wanted : 0;
    }

    private static void keep(double[] d, int at, double impulse0, double impulse1) {
        d[at + Rows.IMPULSE0] = impulse0;
        d[at + Rows.IMPULSE1] = impulse1;
    }

    private static void apply(
            double[] m, int a, int b, double nx, double ny, double j, double onA, double onB) {
        double ma = m[a + INVERSE_MASS] * j;
        double mb = m[b + INVERSE_MASS] * j;
        m[a + VX] -= ma * nx;
        m[a + VY] -= ma * ny;
        m[a + SPIN] -= m[a + INVERSE_INERTIA] * onA;
        m[b + VX] += mb * nx;
        m[b + VY] += mb * ny;
        m[b + SPIN] += m[b + INVERSE_INERTIA] * onB;
    }
}
