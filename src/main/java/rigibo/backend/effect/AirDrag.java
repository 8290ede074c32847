package rigibo.backend.effect;

import rigibo.backend.setup.Require;

/**
 * Quadratic drag of the air: a force of ½·ρ·c·A·v² at the centre of mass, against the motion
 * through the air (Rayleigh, "On the resistance of fluids", 1876). A is the width of the shape as
 * the air sees it, across that motion, times a depth of 1 m: a disc's diameter; a box's height, its
 * width or up to its diagonal, as it is turned. There is no lift and no torque. Where {@link Wind}
 * is declared the air moves.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new AirDrag(1.2, 1.1))); // air at sea level round discs
 * }</pre>
 *
 * @param density ρ of the air in kg/m³, zero or more; at sea level 1.2
 * @param coefficient c of the shape, no unit, zero or more; a disc across its axis 1.1, a box 2
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
}
