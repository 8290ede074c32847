package rigibo.backend.setup;

/**
 * What a body is made of. Where two bodies meet, friction mixes as √(μaμb), elasticity as max(ea,
 * eb), rolling resistance as max(ca, cb) and surface speeds add.
 *
 * @param density kg/m², positive and finite
 * @param friction Coulomb's μ, 0 or more; ice 0.03, wood 0.4, rubber 0.9
 * @param elasticity Newton's coefficient of restitution e, 0 (stays where it lands) to 1 (returns
 *     to its height)
 * @param rollingResistance lever c in m, 0 or more: a rolling body is braked by the torque c·N
 * @param surfaceSpeed of the outline in m/s, counter-clockwise positive: a conveyor's belt
 * @param drag k in 1/s, 0 or more: the force per mass against motion is k·v
 */
public record Material(
        double density,
        double friction,
        double elasticity,
        double rollingResistance,
        double surfaceSpeed,
        double drag) {

    /** Density 1 kg/m², friction 0.5, elasticity 0. */
    public static final Material DEFAULT = new Material(1, 0.5, 0);

    /**
     * Checks every number.
     *
     * @throws IllegalArgumentException naming the field that is out of its range
     */
    public Material {
        Require.positive("Material.density", density, "kg/m²");
        Require.notNegative("Material.friction", friction, "no unit");
        Require.within("Material.elasticity", elasticity, 0, 1, "no unit");
        Require.notNegative("Material.rollingResistance", rollingResistance, "m");
        Require.finite("Material.surfaceSpeed", surfaceSpeed, "m/s");
        Require.notNegative("Material.drag", drag, "1/s");
    }

    /**
     * A material without rolling resistance, surface speed or drag.
     *
     * @param density kg/m², positive and finite
     * @param friction Coulomb's μ, 0 or more
     * @param elasticity 0 to 1
     * @throws IllegalArgumentException naming the field that is out of its range
     */
    public Material(double density, double friction, double elasticity) {
        this(density, friction, elasticity, 0, 0, 0);
    }

    /** The same with another density, kg/m², positive. */
    public Material density(double kilogramsPerSquareMetre) {
        return new Material(
                kilogramsPerSquareMetre,
                friction,
                elasticity,
                rollingResistance,
                surfaceSpeed,
                drag);
    }

    /** The same with another Coulomb friction, 0 or more. */
    public Material friction(double coefficient) {
        return new Material(
                density, coefficient, elasticity, rollingResistance, surfaceSpeed, drag);
    }

    /** The same with another elasticity, 0 to 1. */
    public Material elasticity(double coefficient) {
        return new Material(density, friction, coefficient, rollingResistance, surfaceSpeed, drag);
    }

    /** The same with a rolling resistance; counts where {@code RollingResistance} is declared. */
    public Material rollingResistance(double metres) {
        return new Material(density, friction, elasticity, metres, surfaceSpeed, drag);
    }

    /** The same with a surface speed in m/s; counts where {@code SurfaceSpeed} is declared. */
    public Material surfaceSpeed(double metresPerSecond) {
        return new Material(
                density, friction, elasticity, rollingResistance, metresPerSecond, drag);
    }

    /** The same with a drag k in 1/s; counts where {@code Drag} is declared. */
    public Material drag(double perSecond) {
        return new Material(
                density, friction, elasticity, rollingResistance, surfaceSpeed, perSecond);
    }
}
