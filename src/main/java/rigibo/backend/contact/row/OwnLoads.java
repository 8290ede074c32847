package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * The scale by which the rest of each body is judged: the sum of the magnitudes of the speeds that
 * its pull, and each of its contacts alone, would give it in a kick. Heavy bodies that it does not
 * touch do not enter.
 */
public final class OwnLoads {

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;

    /** By entry of the motions: Σ |j| of its contacts, N·s. */
    private double[] carried = new double[16];

    /** Length of the kick, s. */
    private double kicked;

    public OwnLoads(Bodies bodies, Motions motions, PackedContacts contacts) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Sums the present impulses of contacts, after a kick of a length in s. */
    public void measure(double length) {
        kicked = length;
        if (carried.length < motions.count) {
            carried = new double[motions.slots.length];
        }
        Arrays.fill(carried, 0, motions.count, 0);
        for (int row = 0; row < contacts.count; row++) {
            int at = row * PackedContacts.STRIDE;
            double sum =
                    contacts.data[at + PackedContacts.IMPULSE0]
                            + contacts.data[at + PackedContacts.IMPULSE1]
                            + Math.abs(contacts.data[at + PackedContacts.IMPULSE_T]);
            carried[contacts.bodyA[row] / Motions.STRIDE] += sum;
            carried[contacts.bodyB[row] / Motions.STRIDE] += sum;
        }
    }

    /** The scale of an entry as last measured, m/s. */
    public double of(int entry) {
        double inverseMass = motions.data[entry * Motions.STRIDE + Motions.INVERSE_MASS];
        return kicked * pull(entry) + inverseMass * carried[entry];
    }

    /** Greater component of the acceleration that the effects give an entry, m/s². */
    public double pull(int entry) {
        int slot = motions.slots[entry];
        return Math.max(Math.abs(bodies.accelerationX[slot]), Math.abs(bodies.accelerationY[slot]));
    }
}
