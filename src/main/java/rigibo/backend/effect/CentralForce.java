package rigibo.backend.effect;

import rigibo.backend.setup.Require;

/**
 * Accelerates every dynamic body by s·rⁿ towards a centre at distance r (m), whatever its mass:
 * gravity of a star with n = −2 and s = G·M, or a spring with n = 1 and s = ω². At the centre
 * itself the acceleration is 0.
 *
 * <pre>{@code
 * // The sun at the origin: an attraction that falls with the square of the distance.
 * Pool planets = new Pool(Effects.of(new CentralForce(0, 0, 40, -2)), Accuracy.FINE);
 * }</pre>
 *
 * @param x world x of the centre, m
 * @param y world y of the centre, m, up
 * @param strength s in m^(1−n)/s², positive towards the centre, negative away from it
 * @param power n, −8 to 8
 */
public record CentralForce(double x, double y, double strength, double power) implements Effect {

    /** Largest magnitude of the power accepted. */
    public static final double MOST_POWER = 8;

    /**
     * Checks every number.
     *
     * @throws IllegalArgumentException when one is not finite or the power not within ±8
     */
    public CentralForce {
        Require.finite("CentralForce.x", x, "m");
        Require.finite("CentralForce.y", y, "m");
        Require.finite("CentralForce.strength", strength, "m^(1-n)/s²");
        Require.within("CentralForce.power", power, -MOST_POWER, MOST_POWER, "no unit");
    }

    @Override
    public Kind kind() {
        return Kind.CENTRAL_FORCE;
    }

    @Override
    public double[] numbers() {
        return new double[] {x, y, strength, power};
    }
}
