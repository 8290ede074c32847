package rigibo.backend.contact.solve;

import rigibo.backend.contact.row.Displacement;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.storage.Bodies;

/**
 * Limits what recovery lifts a crowd by. Little moves there that could pay for it, and from storey
 * to storey what is lifted adds up: the lift is spread over time.
 */
final class LiftLimit {

    /**
     * Energy that lifting may take in a substep, as a multiple of what the substep's pull gives
     * what rests: on the average a body is lifted twice as far as it would fall.
     */
    private static final double TIMES_A_FALL = 2;

    private final Bodies bodies;
    private final Motions motions;
    private final Displacement moved;

    LiftLimit(Bodies bodies, Motions motions) {
        this.bodies = bodies;
        this.motions = motions;
        moved = new Displacement(motions);
    }

    /** Notes where all bodies are. */
    void begin() {
        moved.begin();
    }

    /** Takes back what has lifted them by more than may be in h seconds, a share of all. */
    void end(double h) {
        double lift = 0;
        double fall = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE;
            double inverseMass = motions.data[at + Motions.INVERSE_MASS];
            if (inverseMass > 0) {
                int slot = motions.slots[entry];
                double x = bodies.accelerationX[slot];
                double y = bodies.accelerationY[slot];
                lift -=
                        (x * moved.of(at + Motions.DX) + y * moved.of(at + Motions.DY))
                                / inverseMass;
                fall += (x * x + y * y) / inverseMass * h * h / 2;
            }
        }
        if (lift > TIMES_A_FALL * fall) {
            moved.scaleAll(TIMES_A_FALL * fall / lift);
        }
    }
}
