package rigibo.backend.setup;

/**
 * What a body is made of. Where two bodies meet, friction mixes as √(μaμb), elasticity as max(ea,
 * eb), rolling resistance as max(ca, cb) and surface speeds add.
 *
 * @param density kg/m², positive and finite
 * @param friction Coulomb's μ, 0 to 1e9; ice 0.03, wood 0.4, rubber 0.9
 * @param elasticity Newton's coefficient of restitution e, 0 (stays where it lands) to 1 (returns
 *     to its height)
 * @param rollingResistance lever c in m, 0 to 1e9: a rolling body is braked by the torque c·N
 * @param surfaceSpeed of the outline in m/s, up to light's, counter-clockwise positive: a
 *     conveyor's belt
 * @param drag k in 1/s, 0 to 1e100: the force per mass against motion is k·v
 */
public record Material(
        double density,
        double friction,
        double elasticity,
        double rollingResistance,
        double surfaceSpeed,
        double drag) {

    /** Highest friction accepted, no unit: what sticks sticks, and squares of loads stay finite. */
    public static final double MOST_FRICTION = 1e9;

    /** Longest rolling lever accepted, m. */
    public static final double MOST_ROLLING_RESISTANCE = 1e9;

    /** Fastest running surface accepted, m/s: light's speed, as for bodies. */
    public static final double MOST_SURFACE_SPEED = 299_792_458;

    /** Strongest drag accepted, 1/s: it stops whatever moves within any step. */
    public static final double MOST_DRAG = 1e100;

    /** Density 1 kg/m², friction 0.5, elasticity 0. */
    public static final Material DEFAULT = new Material(1, 0.5, 0);

    /**
     * Checks every number.
     *
     * @throws IllegalArgumentException naming the field that is out of its range
     */
    public Material {
        Require.positive("Material.density", density, "kg/m²");
        Require.within("Material.friction", friction, 0, MOST_FRICTION, "no unit");
        Require.within("Material.elasticity", elasticity, 0, 1, "no unit");
        Require.within(
                "Material.rollingResistance", rollingResistance, 0, MOST_ROLLING_RESISTANCE, "m");
        Require.within(
                "Material.surfaceSpeed",
                surfaceSpeed,
                -MOST_SURFACE_SPEED,
                MOST_SURFACE_SPEED,
                "m/s");
        Require.within("Material.drag", drag, 0, MOST_DRAG, "1/s");
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
