package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * What each body of an island would gain in a kick by its own pull and by every one of its contacts
 * alone, all by amount: the scale by which a body's own rest is judged. A heavy neighbour that a
 * body does not touch has no part in it.
 */
public final class OwnLoads {

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;

    /** By entry of the motions: Σ |j| of its contacts, N·s. */
    private double[] carried = new double[16];

    /** How long the kick was, s. */
    private double kicked;

    public OwnLoads(Bodies bodies, Motions motions, PackedContacts contacts) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Adds up what contacts carry now, after a kick of so many seconds. */
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

    /** What an entry would gain, as it was measured last, m/s. */
    public double of(int entry) {
        double inverseMass = motions.data[entry * Motions.STRIDE + Motions.INVERSE_MASS];
        return kicked * pull(entry) + inverseMass * carried[entry];
    }

    /** The acceleration along an axis that the effects give an entry, m/s². */
    public double pull(int entry) {
        int slot = motions.slots[entry];
        return Math.max(Math.abs(bodies.accelerationX[slot]), Math.abs(bodies.accelerationY[slot]));
    }
}
