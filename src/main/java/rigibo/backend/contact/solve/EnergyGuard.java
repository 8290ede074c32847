package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.SingleRows.ROWS_PER_CONTACT;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.SingleRows;

/**
 * Keeps contacts from adding energy. The work of impulses j, without that of driven bodies, is Σ
 * j·(w₀ + w₁)/2, where w₀ and w₁ are the relative speeds along the rows before and after. Solved
 * contacts never do positive work. Where rows could not be solved to the end, all impulses are
 * scaled back until their work is within bounds, which keeps momentum and angular momentum.
 */
public final class EnergyGuard {

    /** Share of the work that is round-off. */
    private static final double ROUND_OFF = 1e-9;

    private final Motions motions;
    private final PackedContacts contacts;
    private final SingleRows single;

    /**
     * The energy of motion before the contacts, J, and the impacts that had been struck by then.
     */
    private double energyBefore;

    private int impactsBefore;

    /** Velocities before the contacts, laid out as the motions. */
    private double[] before = new double[16 * Motions.STRIDE];

    public EnergyGuard(Motions motions, PackedContacts contacts) {
        this.motions = motions;
        this.contacts = contacts;
        single = new SingleRows(motions, contacts);
    }

    /** Notes the energy that there is before the contacts answer. */
    public void begin() {
        energyBefore = motions.energy(motions.data);
        impactsBefore = contacts.impacts;
    }

    /**
     * Whether the energy of motion alone shows that impulses added no more than some J; it does
     * where nothing is driven and no impact was resolved meanwhile.
     */
    private boolean isWithin(double most) {
        boolean isDriven = motions.isAnyDriven || contacts.isAnyRunning;
        boolean isOfContacts = !isDriven && contacts.impacts == impactsBefore;
        return isOfContacts && motions.energy(motions.data) <= energyBefore + most;
    }

    /** Scales all impulses back to what adds no energy, if they do. */
    public void limitEnergy() {
        limitWork(0);
    }

    /**
     * Scales all impulses back to what adds no more than a multiple of the energy of motion before
     * them.
     */
    public void limitGrowth(double multiple) {
        limitWork(multiple * energyBefore);
    }

    /** Scales all impulses back to what adds no more than some J. */
    public void limitWork(double most) {
        if (isWithin(most)) {
            return;
        }
        takeBack();
        double first = work(before);
        // The work of impulses scaled by s is s·Σ j·w₀ + s²·Σ j·(w₁ − w₀)/2.
        double growth = (work(motions.data) - first) / 2;
        if (first + growth > most + ROUND_OFF * growth) {
            double root = Math.sqrt(first * first + 4 * growth * most);
            scale(growth > 0 ? (root - first) / (2 * growth) : 0);
        }
    }

    /** Finds the velocities that there were without the impulses. */
    private void takeBack() {
        int length = motions.count * Motions.STRIDE;
        if (before.length < length) {
            before = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, before, 0, length);
        for (int id = 0; id < ROWS_PER_CONTACT * contacts.count; id++) {
            double impulse = impulse(id);
            if (impulse != 0) {
                single.push(before, id, -impulse, Motions.VX, Motions.VY, Motions.SPIN);
            }
        }
        for (int row = 0; row < contacts.count; row++) {
            double turn = contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE_R];
            int a = contacts.bodyA[row];
            int b = contacts.bodyB[row];
            before[a + Motions.SPIN] += motions.data[a + Motions.INVERSE_INERTIA] * turn;
            before[b + Motions.SPIN] -= motions.data[b + Motions.INVERSE_INERTIA] * turn;
        }
    }

    private double impulse(int id) {
        int at = id / ROWS_PER_CONTACT * PackedContacts.STRIDE;
        return contacts.data[at + SingleRows.impulseColumn(id)];
    }

    /** Scales all impulses back to what leaves no speed above a limit in m/s, if one is. */
    public void limitSpeed(double limit) {
        if (motions.fastest() <= limit) {
            return;
        }
        takeBack();
        double share = 1;
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            share = Math.min(share, shareWithin(limit, at + Motions.VX));
            share = Math.min(share, shareWithin(limit, at + Motions.VY));
        }
        if (share < 1) {
            scale(share);
        }
    }

    private double shareWithin(double limit, int column) {
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
                double speed = single.relative(m, id, Motions.VX, Motions.VY, Motions.SPIN);
                sum += impulse * (speed - single.running(id));
            }
        }
        for (int row = 0; row < contacts.count; row++) {
            double turning =
                    m[contacts.bodyB[row] + Motions.SPIN] - m[contacts.bodyA[row] + Motions.SPIN];
            sum += contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE_R] * turning;
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
        for (int at = 0; at < contacts.count * PackedContacts.STRIDE; at += PackedContacts.STRIDE) {
            contacts.data[at + PackedContacts.IMPULSE0] *= share;
            contacts.data[at + PackedContacts.IMPULSE1] *= share;
            contacts.data[at + PackedContacts.IMPULSE_T] *= share;
            contacts.data[at + PackedContacts.IMPULSE_R] *= share;
        }
    }
}
