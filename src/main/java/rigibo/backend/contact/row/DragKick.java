package rigibo.backend.contact.row;

import rigibo.backend.geometry.Exponential;
import rigibo.backend.storage.Bodies;

/**
 * A kick with linear drag: the exact solution of v′ = a − k·v, which is v·e^(−kh) + a·(1 −
 * e^(−kh))/k.
 */
public final class DragKick {

    private final Bodies bodies;
    private final Motions motions;

    public DragKick(Bodies bodies, Motions motions) {
        this.bodies = bodies;
        this.motions = motions;
    }

    /**
     * Advances the velocities from one time to a later one, and stores that length for each body,
     * s.
     */
    void accelerate(double from, double to, double[] lengths) {
        double[] m = motions.data;
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            int at = entry * Motions.STRIDE;
            double h = to - Math.max(from, bodies.pileTime[slot]);
            if (m[at + Motions.INVERSE_MASS] > 0 && h > 0) {
                lengths[at + Kick.LENGTH] = h;
                double k = bodies.drag[slot];
                double ax = bodies.accelerationX[slot];
                double ay = bodies.accelerationY[slot];
                if (k > 0) {
                    double lost = -Exponential.expm1(-k * h);
                    m[at + Motions.VX] += lost * (ax / k - motions.frameX - m[at + Motions.VX]);
                    m[at + Motions.VY] += lost * (ay / k - motions.frameY - m[at + Motions.VY]);
                } else {
                    m[at + Motions.VX] += h * ax;
                    m[at + Motions.VY] += h * ay;
                }
            }
        }
    }
}
