package rigibo.backend;

import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Require;

/**
 * A blast from a point. Each shape in reach gets an impulse at its point nearest to the centre,
 * directed away from the centre and proportional to the width of the shape as seen from there.
 *
 * <pre>{@code
 * pool.explode(Explosion.at(3, 1).radius(2).falloff(1).impulsePerMetre(20));
 * }</pre>
 *
 * @param x world x, m
 * @param y world y, m, up
 * @param radius distance up to which the blast has its full strength, m, 0 or more
 * @param falloff further distance over which the strength falls linearly to 0, m, 0 or more
 * @param impulsePerMetre impulse for each metre of width, N·s/m; a negative one pulls inwards
 * @param filter which shapes it acts on
 */
public record Explosion(
        double x, double y, double radius, double falloff, double impulsePerMetre, Filter filter) {

    /**
     * Checks every number.
     *
     * @throws IllegalArgumentException naming the field that is out of its range
     */
    public Explosion {
        Require.finite("Explosion.x", x, "m");
        Require.finite("Explosion.y", y, "m");
        Require.notNegative("Explosion.radius", radius, "m");
        Require.notNegative("Explosion.falloff", falloff, "m");
        Require.finite("Explosion.impulsePerMetre", impulsePerMetre, "N·s/m");
        Require.present("Explosion.filter", filter);
    }

    /**
     * A blast of 1 N·s/m up to 1 m from a world point (m), nothing beyond; it acts on all shapes.
     */
    public static Explosion at(double x, double y) {
        return new Explosion(x, y, 1, 0, 1, Filter.ALL);
    }

    /** A copy with another radius of full strength, m, 0 or more. */
    public Explosion radius(double metres) {
        return new Explosion(x, y, metres, falloff, impulsePerMetre, filter);
    }

    /** A copy with another falloff distance beyond the radius, m, 0 or more. */
    public Explosion falloff(double metres) {
        return new Explosion(x, y, radius, metres, impulsePerMetre, filter);
    }

    /** A copy of another strength, N·s for each metre of width. */
    public Explosion impulsePerMetre(double newtonSecondsPerMetre) {
        return new Explosion(x, y, radius, falloff, newtonSecondsPerMetre, filter);
    }

    /** A copy that acts only on shapes which the filter meets. */
    public Explosion filter(Filter whom) {
        return new Explosion(x, y, radius, falloff, impulsePerMetre, whom);
    }

    /** Strength at a distance (m) from the centre as a share of the full strength, 0 to 1. */
    double shareAt(double distance) {
        return distance <= radius
                ? 1
                : Math.max(0, 1 - (distance - radius) / Math.max(falloff, Double.MIN_NORMAL));
    }
}
