package rigibo.backend.contact.solve;

import rigibo.backend.contact.row.Displacement;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.storage.Bodies;

/**
 * Limits the lift of a crowd by recovery. Little moves there that could supply the energy, and
 * lifts add up from storey to storey, so they are spread over time.
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

    /** Takes back the lift beyond the limit of h seconds, by the same share for all bodies. */
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
