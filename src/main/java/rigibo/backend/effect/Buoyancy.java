package rigibo.backend.effect;

import rigibo.backend.setup.Require;

/**
 * A body of water at rest under a level. What is under water is lifted by the weight of the water
 * it displaces, at its centroid (Archimedes), and every part of it is braked by {@code drag} times
 * the momentum that the displaced water would have at that part's velocity. Area, centroid and
 * second moment of what is under water are exact for discs and polygons. Weight is the declared
 * {@link Gravity}'s; it has to be declared.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new Buoyancy(2, 1000, 2))); // water up to y = 2 m
 * }</pre>
 *
 * @param level y of the surface, m
 * @param density of the water, kg/m² as for materials, zero or more; 1000 at a depth of 1 m
 * @param drag 1/s, zero or more
 */
public record Buoyancy(double level, double density, double drag) implements Effect {

    /**
     * Checks every number.
     *
     * @throws IllegalArgumentException when one is not finite, or density or drag negative
     */
    public Buoyancy {
        Require.finite("Buoyancy.level", level, "m");
        Require.notNegative("Buoyancy.density", density, "kg/m²");
        Require.notNegative("Buoyancy.drag", drag, "1/s");
    }
}
