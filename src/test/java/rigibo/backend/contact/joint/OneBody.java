package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

/** The motions of one body beside the ground, for rows that push it. */
final class OneBody {

    /** The body's offset in the motions. */
    static final int BODY = Motions.STRIDE;

    private OneBody() {}

    /** Packs one body at rest, whose mass in kg and inertia in kg·m² are the same number. */
    static Motions of(double mass) {
        Motions motions = new Motions(true);
        motions.data = new double[2 * Motions.STRIDE];
        motions.slots = new int[2];
        motions.reach = new double[] {1, 1};
        motions.count = 2;
        motions.data[BODY + Motions.INVERSE_MASS] = 1 / mass;
        motions.data[BODY + Motions.INVERSE_INERTIA] = 1 / mass;
        return motions;
    }
}
