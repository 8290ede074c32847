package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.row.Motions.SPIN;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

/**
 * Solves the rolling rows, |jᵣ| ≤ c·Σjₙ, of all contacts with rolling resistance, each together
 * with the friction of its contact.
 */
public final class RollingSolver implements Rubbing {

    private final Bodies bodies;
    private final Pairs pairs;
    private final Motions motions;
    private final PackedContacts contacts;

    /** Null if friction is not declared; then rolling bodies slide freely. */
    private final FrictionSolver friction;

    private int[] rolling = new int[16];
    private int count;

    public RollingSolver(
            DataStorage data, Motions motions, PackedContacts contacts, FrictionSolver friction) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.motions = motions;
        this.contacts = contacts;
        this.friction = friction;
    }

    @Override
    public void begin(double firstKick) {
        if (rolling.length < contacts.count) {
            rolling = new int[contacts.pair.length];
        }
        count = 0;
        for (int row = 0; row < contacts.count; row++) {
            double lever = pairs.rollingLever(bodies, contacts.pair[row]);
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
        int at = row * PackedContacts.STRIDE;
        double ia = motions.data[contacts.bodyA[row] + INVERSE_INERTIA];
        double ib = motions.data[contacts.bodyB[row] + INVERSE_INERTIA];
        contacts.data[at + PackedContacts.ROLLING] = lever;
        contacts.data[at + PackedContacts.INERTIA_R] = ia + ib > 0 ? 1 / (ia + ib) : 0;
        contacts.data[at + PackedContacts.IMPULSE_R] =
                pairs.heldTorque(contacts.pair[row]) * firstKick;
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
            double impulse =
                    contacts.data[rolling[i] * PackedContacts.STRIDE + PackedContacts.IMPULSE_R];
            pairs.rollingTorque[contacts.pair[rolling[i]]] = impulse * (2 / h);
        }
        if (friction != null) {
            friction.store(h);
        }
    }

    /**
     * Solves rolling and friction together where both hold. Solved in turn, rolling would brake the
     * turning and friction the motion, each would undo a part of the other, and the wheel would
     * creep back.
     */
    @Override
    public void roll(int row) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        double load = d[at + PackedContacts.IMPULSE0] + d[at + PackedContacts.IMPULSE1];
        double mostSlide = d[at + PackedContacts.FRICTION] * load;
        double mostRoll = d[at + PackedContacts.ROLLING] * load;
        double ia = motions.data[contacts.bodyA[row] + INVERSE_INERTIA];
        double ib = motions.data[contacts.bodyB[row] + INVERSE_INERTIA];
        double stiff = 1 + PackedContacts.COMPLIANCE;
        double slides = mostSlide > 0 ? stiff / d[at + PackedContacts.MASS_T] : 0;
        double turns = stiff * (ia + ib);
        double both = d[at + PackedContacts.LEVER_TB] * ib + d[at + PackedContacts.LEVER_TA] * ia;
        double determinant = slides * turns - both * both;
        if (determinant > 0) {
            double oldT = d[at + PackedContacts.IMPULSE_T];
            double oldR = d[at + PackedContacts.IMPULSE_R];
            double gives = PackedContacts.COMPLIANCE;
            double vt = friction.slidingSpeed(row) + gives * oldT / d[at + PackedContacts.MASS_T];
            double wr = turning(row) + gives * (ia + ib) * oldR;
            double tangent = oldT + (both * wr - turns * vt) / determinant;
            double roll = oldR + (both * vt - slides * wr) / determinant;
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
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        double most =
                d[at + PackedContacts.ROLLING]
                        * (d[at + PackedContacts.IMPULSE0] + d[at + PackedContacts.IMPULSE1]);
        double wanted =
                (d[at + PackedContacts.IMPULSE_R] - d[at + PackedContacts.INERTIA_R] * turning(row))
                        / (1 + PackedContacts.COMPLIANCE);
        keepRoll(row, FrictionSolver.clamp(wanted, most));
    }

    /** Angular velocity of B relative to A, rad/s. */
    private double turning(int row) {
        return motions.data[contacts.bodyB[row] + SPIN] - motions.data[contacts.bodyA[row] + SPIN];
    }

    private void keepRoll(int row, double impulse) {
        double[] d = contacts.data;
        double[] m = motions.data;
        int at = row * PackedContacts.STRIDE;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double change = impulse - d[at + PackedContacts.IMPULSE_R];
        d[at + PackedContacts.IMPULSE_R] = impulse;
        m[a + SPIN] -= m[a + INVERSE_INERTIA] * change;
        m[b + SPIN] += m[b + INVERSE_INERTIA] * change;
    }
}
