package rigibo.backend;

import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Require;

/**
 * A blast from a point: every shape within reach is struck where it is nearest, away from the
 * point, by so much for each metre that it is wide as seen from there.
 *
 * <pre>{@code
 * pool.explode(Explosion.at(3, 1).radius(2).falloff(1).impulsePerMetre(20));
 * }</pre>
 *
 * @param x world x, m
 * @param y world y, m, up
 * @param radius within which the blast is full, m
 * @param falloff beyond the radius, within which it falls evenly to nothing, m
 * @param impulsePerMetre N·s for each metre of width; below 0 it sucks in
 * @param filter whom it strikes
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

    /** Of 1 N·s/m within 1 m, and of nothing beyond; it strikes everybody. */
    public static Explosion at(double x, double y) {
        return new Explosion(x, y, 1, 0, 1, Filter.ALL);
    }

    /** The same that is full within another radius, m, 0 or more. */
    public Explosion radius(double metres) {
        return new Explosion(x, y, metres, falloff, impulsePerMetre, filter);
    }

    /** The same that falls to nothing within so many metres more, 0 or more. */
    public Explosion falloff(double metres) {
        return new Explosion(x, y, radius, metres, impulsePerMetre, filter);
    }

    /** The same of another strength, N·s for each metre of width. */
    public Explosion impulsePerMetre(double newtonSecondsPerMetre) {
        return new Explosion(x, y, radius, falloff, newtonSecondsPerMetre, filter);
    }

    /** The same that strikes only whom a filter meets. */
    public Explosion filter(Filter whom) {
        return new Explosion(x, y, radius, falloff, impulsePerMetre, whom);
    }

    /** The share of its full strength at a distance in m. */
    double shareAt(double distance) {
        return distance <= radius
                ? 1
                : Math.max(0, 1 - (distance - radius) / Math.max(falloff, Double.MIN_NORMAL));
    }
}
