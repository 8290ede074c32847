package rigibo.backend.contact.solve;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

/**
 * Undoes half of a solver's round. Friction and normal loads depend on each other, so that rounds
 * may cycle; the middle of a cycle is nearer to the solution than any of its points. Bounds still
 * hold, since they are convex.
 */
public final class Halfway {

    private final Motions motions;
    private final PackedContacts contacts;

    /** Velocities at the start of the round, laid out as the motions. */
    private double[] velocities = new double[64];

    /** Impulses at the start of the round, by row. */
    private double[] impulses = new double[64];

    public Halfway(Motions motions, PackedContacts contacts) {
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Stores the state at the start of a round. */
    public void begin() {
        int moving = motions.count * Motions.STRIDE;
        int touching = contacts.count * PackedContacts.STRIDE;
        if (velocities.length < moving) {
            velocities = new double[motions.data.length];
        }
        if (impulses.length < touching) {
            impulses = new double[contacts.data.length];
        }
        System.arraycopy(motions.data, 0, velocities, 0, moving);
        System.arraycopy(contacts.data, 0, impulses, 0, touching);
    }

    /** Undoes half of the round. */
    public void end() {
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            for (int column = at; column < at + Motions.DX; column++) {
                motions.data[column] = (motions.data[column] + velocities[column]) / 2;
            }
        }
        for (int at = 0; at < contacts.count * PackedContacts.STRIDE; at += PackedContacts.STRIDE) {
            halve(at + PackedContacts.IMPULSE0);
            halve(at + PackedContacts.IMPULSE1);
            halve(at + PackedContacts.IMPULSE_T);
            halve(at + PackedContacts.IMPULSE_R);
        }
    }

    /** Undoes the whole round. */
    public void takeBack() {
        System.arraycopy(velocities, 0, motions.data, 0, motions.count * Motions.STRIDE);
        System.arraycopy(impulses, 0, contacts.data, 0, contacts.count * PackedContacts.STRIDE);
    }

    private void halve(int column) {
        contacts.data[column] = (contacts.data[column] + impulses[column]) / 2;
    }
}
