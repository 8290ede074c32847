package rigibo.backend.contact.bounce;

import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/** The contacts of a packed island that can bounce, and the closing speed from which on they do. */
final class BounceRows {

    /**
     * Least closing speed of an impact, as a share of the speed that the effects add in one
     * substep; passes leave smaller speeds as errors.
     */
    private static final double PULLED = 0.25;

    private final Bodies bodies;
    private final Pairs pairs;
    private final PackedContacts contacts;

    /** Rows with elasticity. */
    int[] elastic = new int[16];

    /** By row with elasticity: closing speed from which on it bounces, m/s. */
    double[] bounceSpeeds = new double[16];

    int count;

    BounceRows(DataStorage data, PackedContacts contacts) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.contacts = contacts;
    }

    /** Lists the rows of the packed island, for substeps of h seconds. */
    void begin(double h) {
        if (elastic.length < contacts.count) {
            elastic = new int[contacts.pair.length];
            bounceSpeeds = new double[contacts.pair.length];
        }
        count = 0;
        for (int row = 0; row < contacts.count; row++) {
            double elasticity = pairs.elasticity[contacts.pair[row]];
            if (elasticity > 0) {
                contacts.data[row * PackedContacts.STRIDE + PackedContacts.ELASTICITY] = elasticity;
                bounceSpeeds[count] = bounceSpeed(row, h);
                contacts.data[row * PackedContacts.STRIDE + PackedContacts.BOUNCE_SPEED] =
                        bounceSpeeds[count];
                elastic[count++] = row;
            }
        }
    }

    /**
     * Closing speed from which on a contact bounces, m/s. A contact is pressed by the acceleration
     * of the effects or by the load it carried, whichever is larger; inside a heap that load comes
     * from far above. It counts by the bodies' masses alone: levers are not known yet of bodies
     * that join the pile within the step. Speed that a body gains by that pressure within a substep
     * is load, not an impact.
     */
    private double bounceSpeed(int row, double h) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        int pair = contacts.pair[row];
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double load = pairs.normalForce[2 * pair] + pairs.normalForce[2 * pair + 1];
        double pressing =
                Math.max(
                        load * (inverseMass(a) + inverseMass(b)),
                        PairTolerances.pressingAcceleration(
                                bodies, a, b, pairs.normalX[pair], pairs.normalY[pair]));
        double unseen = PairTolerances.restSpeed(pressing, d[at + PackedContacts.WIDTH]);
        double pulled = Math.max(acceleration(a), acceleration(b)) * h * PULLED;
        return Math.max(pulled, Math.max(unseen, pressing * h));
    }

    private double inverseMass(int slot) {
        return bodies.isMoved(slot) ? bodies.inverseMass[slot] : 0;
    }

    private double acceleration(int slot) {
        double x = bodies.accelerationX[slot];
        double y = bodies.accelerationY[slot];
        return bodies.isMoved(slot) ? Math.sqrt(x * x + y * y) : 0;
    }
}
