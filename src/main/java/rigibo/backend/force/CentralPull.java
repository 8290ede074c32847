package rigibo.backend.force;

import rigibo.backend.effect.CentralForce;
import rigibo.backend.geometry.Logarithm;

/** a = −s·rⁿ·(r/r), computed as the factor s·(r²)^((n − 1)/2) times the vector to the centre. */
final class CentralPull implements ChangingForce {

    /** The power of Newton's gravity, whose factor needs no exponential. */
    private static final double INVERSE_SQUARE = -2;

    private final CentralForce centre;
    private final double exponent;

    CentralPull(CentralForce centre) {
        this.centre = centre;
        exponent = (centre.power() - 1) / 2;
    }

    @Override
    public void add(Instant at) {
        double dx = centre.x() - at.x;
        double dy = centre.y() - at.y;
        double squared = dx * dx + dy * dy;
        if (squared > 0) {
            double factor = centre.strength() * share(squared);
            at.accelerationX += factor * dx;
            at.accelerationY += factor * dy;
        }
    }

    private double share(double squared) {
        if (exponent == 0) {
            return 1;
        }
        return centre.power() == INVERSE_SQUARE
                ? 1 / (squared * Math.sqrt(squared))
                : Logarithm.pow(squared, exponent);
    }
}
