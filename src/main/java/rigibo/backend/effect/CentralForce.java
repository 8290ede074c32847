package rigibo.backend.effect;

import rigibo.backend.setup.Require;

/**
 * An acceleration of s·rⁿ towards a centre, whatever the mass, at the distance r in m: planets at n
 * = −2, where s is G·M; springs at n = 1, where s is ω². At the centre itself it is 0.
 *
 * <pre>{@code
 * // The sun at the origin: an attraction that falls with the square of the distance.
 * Pool planets = new Pool(Effects.of(new CentralForce(0, 0, 40, -2)), Accuracy.FINE);
 * }</pre>
 *
 * @param x world place of the centre, m
 * @param y world place of the centre, m, up
 * @param strength s in m^(1−n)/s², positive towards the centre, negative away from it
 * @param power n, −8 to 8
 */
public record CentralForce(double x, double y, double strength, double power) implements Effect {

    /** Steepest power accepted, without sign. */
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
}
