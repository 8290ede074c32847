package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.SingleRows.ROWS_PER_CONTACT;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.SingleRows;

/**
 * Keeps contacts from adding energy. The work of impulses j, without that of driven bodies, is Σ
 * j·(w₀ + w₁)/2, where w₀ and w₁ are the relative speeds along the rows before and after. Converged
 * contacts never do positive work. If rows did not converge, all impulses are scaled down until
 * their work is within bounds, which keeps momentum and angular momentum.
 */
public final class EnergyGuard {

    /** Share of the work that is round-off. */
    private static final double WORK_ROUND_OFF = 1e-9;

    /** Rounds that scale only the impulses of bodies that are too fast, before all are scaled. */
    private static final int ROUNDS = 16;

    private final Motions motions;
    private final PackedContacts contacts;
    private final SingleRows single;

    /** Kinetic energy before contacts are solved, J. */
    private double energyBefore;

    /** Number of impacts resolved by then. */
    private int impactsBefore;

    /** Velocities before contacts are solved, laid out as the motions. */
    private double[] before = new double[16 * Motions.STRIDE];

    /** By entry of the motions: share of its impulses that the body keeps. */
    private double[] shares = new double[16];

    public EnergyGuard(Motions motions, PackedContacts contacts) {
        this.motions = motions;
        this.contacts = contacts;
        single = new SingleRows(contacts);
    }

    /** Stores the kinetic energy before contacts are solved. */
    public void begin() {
        energyBefore = motions.energy(motions.data);
        impactsBefore = contacts.impacts;
    }

    /**
     * Whether the kinetic energy alone proves that impulses added no more than an energy in J; that
     * is possible if nothing is driven and no impact was resolved meanwhile.
     */
    private boolean isWithin(double most) {
        boolean isDriven = motions.isAnyDriven || contacts.isAnyRunning;
        boolean isOfContacts = !isDriven && contacts.impacts == impactsBefore;
        return isOfContacts && motions.energy(motions.data) <= energyBefore + most;
    }

    /** Scales all impulses down so that they add no energy. */
    public void limitEnergy() {
        limitWork(0);
    }

    /**
     * Scales all impulses down so that they add no more than a multiple of the kinetic energy
     * before them.
     */
    public void limitGrowth(double multiple) {
        limitWork(multiple * energyBefore);
    }

    /** Scales all impulses down so that they add no more than an energy in J. */
    public void limitWork(double most) {
        if (isWithin(most)) {
            return;
        }
        takeBack();
        double first = work(before);
        // The work of impulses scaled by s is s·Σ j·w₀ + s²·Σ j·(w₁ − w₀)/2.
        double growth = (work(motions.data) - first) / 2;
        if (first + growth > most + WORK_ROUND_OFF * growth) {
            double root = Math.sqrt(first * first + 4 * growth * most);
            scale(growth > 0 ? (root - first) / (2 * growth) : 0);
        }
    }

    /** Computes the velocities without the impulses. */
    private void takeBack() {
        int length = motions.count * Motions.STRIDE;
        if (before.length < length) {
            before = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, before, 0, length);
        for (int id = 0; id < ROWS_PER_CONTACT * contacts.count; id++) {
            double impulse = impulse(id);
            if (impulse != 0) {
                single.push(before, id, -impulse);
            }
        }
        for (int row = 0; row < contacts.count; row++) {
            turn(before, row, -rolling(row));
        }
    }

    private double rolling(int row) {
        return contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE_R];
    }

    private double impulse(int id) {
        int at = id / ROWS_PER_CONTACT * PackedContacts.STRIDE;
        return contacts.data[at + SingleRows.impulseColumn(id)];
    }

    /**
     * Scales impulses down so that they leave no speed above a limit, m/s. In a crowd only the
     * impulses of bodies that are too fast are scaled: if all were, a whole heap would fall because
     * of one stone, until passes found its loads again.
     */
    public void limitSpeed(double limit) {
        if (motions.fastest() <= limit) {
            return;
        }
        takeBack();
        int rounds = contacts.areCrowd() ? ROUNDS : 0;
        for (int round = 0; round < rounds; round++) {
            if (!holdBack(limit)) {
                return;
            }
        }
        double share = 1;
        for (int entry = 1; entry < motions.count; entry++) {
            share = Math.min(share, shareWithin(limit, entry));
        }
        if (share < 1) {
            scale(share);
        }
    }

    /**
     * Scales down the impulses of bodies that are too fast, at both bodies of each contact, which
     * keeps momentum; returns whether there were any. A neighbour that loses its support may be too
     * fast in the next round.
     */
    private boolean holdBack(double limit) {
        if (shares.length < motions.count) {
            shares = new double[motions.slots.length];
        }
        shares[0] = 1;
        boolean isAny = false;
        for (int entry = 1; entry < motions.count; entry++) {
            shares[entry] = shareWithin(limit, entry);
            isAny |= shares[entry] < 1;
        }
        for (int row = 0; isAny && row < contacts.count; row++) {
            double ofA = shares[contacts.bodyA[row] / Motions.STRIDE];
            double ofB = shares[contacts.bodyB[row] / Motions.STRIDE];
            if (ofA < 1 || ofB < 1) {
                scale(row, Math.min(ofA, ofB));
            }
        }
        return isAny;
    }

    /** Scales the impulses of one contact down and takes the difference from its bodies. */
    private void scale(int row, double share) {
        for (int id = ROWS_PER_CONTACT * row; id < ROWS_PER_CONTACT * (row + 1); id++) {
            double less = (share - 1) * impulse(id);
            single.push(motions.data, id, less);
        }
        turn(motions.data, row, (share - 1) * rolling(row));
        contacts.scaleImpulses(row, share);
    }

    /** Applies an angular impulse in N·m·s between the two bodies of a contact. */
    private void turn(double[] m, int row, double impulse) {
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        m[a + Motions.SPIN] -= motions.data[a + Motions.INVERSE_INERTIA] * impulse;
        m[b + Motions.SPIN] += motions.data[b + Motions.INVERSE_INERTIA] * impulse;
    }

    /** Share of a body's impulses at which it is no faster than a limit in m/s. */
    private double shareWithin(double limit, int entry) {
        int at = entry * Motions.STRIDE;
        double ofX = columnWithin(limit, at + Motions.VX);
        return Math.min(ofX, columnWithin(limit, at + Motions.VY));
    }

    private double columnWithin(double limit, int column) {
        double speed = Math.abs(motions.data[column]);
        double change = Math.abs(motions.data[column] - before[column]);
        boolean isAnswered = speed <= limit || change == 0;
        return isAnswered ? 1 : Math.max(0, limit - Math.abs(before[column])) / change;
    }

    /** Σ j·w at velocities laid out as the motions, J. */
    private double work(double[] m) {
        double sum = 0;
        for (int id = 0; id < ROWS_PER_CONTACT * contacts.count; id++) {
            double impulse = impulse(id);
            if (impulse != 0) {
                double speed = single.relative(m, id);
                sum += impulse * (speed - single.running(id));
            }
        }
        for (int row = 0; row < contacts.count; row++) {
            double turning =
                    m[contacts.bodyB[row] + Motions.SPIN] - m[contacts.bodyA[row] + Motions.SPIN];
            sum += rolling(row) * turning;
        }
        return sum;
    }

    private void scale(double share) {
        double[] m = motions.data;
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            for (int column = at; column < at + Motions.DX; column++) {
                m[column] = before[column] + share * (m[column] - before[column]);
            }
        }
        for (int row = 0; row < contacts.count; row++) {
            contacts.scaleImpulses(row, share);
        }
    }
}
