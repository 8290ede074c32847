package rigibo.backend.effect;

import rigibo.backend.setup.Require;

import java.util.List;

/**
 * Still water below a level. The submerged part of a body is lifted by the weight of the water it
 * displaces, at the centroid of that part (Archimedes), and each point of it is braked by {@code
 * drag} times the momentum that the displaced water would have at that point's velocity. Area,
 * centroid and second moment of the submerged part are exact for discs and polygons. {@link
 * Gravity} must be declared.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new Buoyancy(2, 1000, 2))); // water up to y = 2 m
 * }</pre>
 *
 * @param level world y of the surface, m
 * @param density density of the water, kg/m² as for materials, 0 or more; water 1 m deep has 1000
 * @param drag rate of braking, 1/s, 0 or more
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

    @Override
    public Kind kind() {
        return Kind.BUOYANCY;
    }

    @Override
    public List<List<Kind>> needs() {
        return List.of(List.of(Kind.GRAVITY));
    }

    @Override
    public double[] numbers() {
        return new double[] {level, density, drag};
    }
}
