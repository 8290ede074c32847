package rigibo.backend.contact;

import static rigibo.backend.contact.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.Motions.SPIN;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

/**
 * The rolling rows |jᵣ| ≤ c·Σjₙ, each solved together with the friction of its contact. A contact
 * without rolling resistance is not on the list.
 */
final class RollingSolver implements Rubbing {

    private final Bodies bodies;
    private final Pairs pairs;
    private final Motions motions;
    private final Rows rows;

    /** Null where friction is not declared: then what rolls may slide as well. */
    private final FrictionSolver friction;

    private int[] rolling = new int[16];
    private int count;

    RollingSolver(DataStorage data, Motions motions, Rows rows, FrictionSolver friction) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.motions = motions;
        this.rows = rows;
        this.friction = friction;
    }

    @Override
    public void begin(double firstKick) {
        if (rolling.length < rows.count) {
            rolling = new int[rows.pair.length];
        }
        count = 0;
        for (int row = 0; row < rows.count; row++) {
            double lever = pairs.rollingLever(bodies, rows.pair[row]);
            if (lever > 0) {
                write(row, lever, firstKick);
                rolling[count++] = row;
            }
        }
        if (friction != null) {
            friction.begin(firstKick);
        }
    }

    private void write(int row, double lever, double firstKick) {
        int at = row * Rows.STRIDE;
        double ia = motions.data[rows.bodyA[row] + INVERSE_INERTIA];
        double ib = motions.data[rows.bodyB[row] + INVERSE_INERTIA];
        rows.data[at + Rows.ROLLING] = lever;
        rows.data[at + Rows.INERTIA_R] = ia + ib > 0 ? 1 / (ia + ib) : 0;
        rows.data[at + Rows.IMPULSE_R] = pairs.heldTorque(rows.pair[row]) * firstKick;
    }

    @Override
    public void refresh() {
        if (friction != null) {
            friction.refresh();
        }
    }

    @Override
    public int rowCount() {
        return count + (friction == null ? 0 : friction.rowCount());
    }

    @Override
    public void store(double h) {
        for (int i = 0; i < count; i++) {
            double impulse = rows.data[rolling[i] * Rows.STRIDE + Rows.IMPULSE_R];
            pairs.rollingTorque[rows.pair[rolling[i]]] = impulse * (2 / h);
        }
        if (friction != null) {
            friction.store(h);
        }
    }

    /**
     * Rolling brakes the turning, and friction then the moving: where both hold they hold together,
     * or one would keep undoing a part of the other and the wheel would creep back.
     */
    @Override
    public void roll(int row) {
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
            double vt = friction.slidingSpeed(row);
            double wr = turning(row);
            double tangent = d[at + Rows.IMPULSE_T] + (both * wr - (ia + ib) * vt) / determinant;
            double roll = d[at + Rows.IMPULSE_R] + (both * vt - slides * wr) / determinant;
            if (Math.abs(tangent) <= mostSlide && Math.abs(roll) <= mostRoll) {
                friction.keepTangent(row, tangent);
                keepRoll(row, roll);
                return;
            }
        }
        brakeTurning(row);
        if (mostSlide > 0) {
            friction.slide(row);
        }
    }

    private void brakeTurning(int row) {
        double[] d = rows.data;
        int at = row * Rows.STRIDE;
        double most = d[at + Rows.ROLLING] * (d[at + Rows.IMPULSE0] + d[at + Rows.IMPULSE1]);
        double wanted = d[at + Rows.IMPULSE_R] - d[at + Rows.INERTIA_R] * turning(row);
        keepRoll(row, FrictionSolver.clamp(wanted, most));
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
        d[at + Rows.IMPULSE_R] = impulse;
        m[a + SPIN] -= m[a + INVERSE_INERTIA] * change;
        m[b + SPIN] += m[b + INVERSE_INERTIA] * change;
    }
}
