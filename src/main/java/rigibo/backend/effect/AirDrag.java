package rigibo.backend.effect;

import rigibo.backend.setup.Require;

/**
 * Quadratic air drag: a force of ½·ρ·c·A·v² at the centre of mass, against the velocity v through
 * the air (Rayleigh, "On the resistance of fluids", 1876). A is the extent of the shape across v
 * times a depth of 1 m: the diameter of a disc; for a box anything from its shorter side to its
 * diagonal, depending on its angle. There is no lift and no torque. Where {@link Wind} is declared,
 * the air moves.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new AirDrag(1.2, 1.1))); // air at sea level round discs
 * }</pre>
 *
 * @param density ρ of the air, kg/m³, 0 or more; 1.2 at sea level
 * @param coefficient drag coefficient c, no unit, 0 or more; about 1.1 for a disc (a cylinder
 *     across its axis), 2 for a box
 */
public record AirDrag(double density, double coefficient) implements Effect {

    /**
     * Checks both numbers.
     *
     * @throws IllegalArgumentException when one is negative or not finite
     */
    public AirDrag {
        Require.notNegative("AirDrag.density", density, "kg/m³");
        Require.notNegative("AirDrag.coefficient", coefficient, "no unit");
    }

    @Override
    public Kind kind() {
        return Kind.AIR_DRAG;
    }

    @Override
    public double[] numbers() {
        return new double[] {density, coefficient};
    }
}
