package rigibo.backend.setup;

/**
 * What a body is made of. Where two bodies meet, friction mixes as √(μaμb), elasticity as max(ea,
 * eb), rolling resistance as max(ca, cb) and surface speeds add.
 *
 * <pre>{@code
 * Material oak = new Material(700, 0.4, 0.3); // kg/m², Coulomb's friction, elasticity
 * Material belt = oak.surfaceSpeed(-2); // m/s: carries to the right
 * }</pre>
 *
 * @param density kg/m², positive and finite
 * @param friction Coulomb's μ, 0 to 1e9; ice 0.03, wood 0.4, rubber 0.9
 * @param elasticity Newton's coefficient of restitution e, 0 (stays where it lands) to 1 (returns
 *     to its height)
 * @param rollingResistance lever c in m, 0 to 1e9: a rolling body is braked by the torque c·N
 * @param surfaceSpeed of the outline in m/s, up to light's, counter-clockwise positive: a
 *     conveyor's belt
 * @param drag k in 1/s, 0 to 1e100: the force per mass against motion is k·v
 * @param oneWayX normal of a one-way surface in the body's frame, a unit vector; see {@link
 *     #oneWay}
 * @param oneWayY likewise; both 0 where the surface is solid all round
 */
public record Material(
        double density,
        double friction,
        double elasticity,
        double rollingResistance,
        double surfaceSpeed,
        double drag,
        double oneWayX,
        double oneWayY) {

    /** Highest friction accepted, no unit: what sticks sticks, and squares of loads stay finite. */
    public static final double MOST_FRICTION = 1e9;

    /** Longest rolling lever accepted, m. */
    public static final double MOST_ROLLING_RESISTANCE = 1e9;

    /** Fastest running surface accepted, m/s: light's speed, as for bodies. */
    public static final double MOST_SURFACE_SPEED = 299_792_458;

    /** Strongest drag accepted, 1/s: it stops whatever moves within any step. */
    public static final double MOST_DRAG = 1e100;

    /** How far the square of a unit vector's length may be off 1. */
    private static final double UNIT = 1e-12;

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
        boolean isUnit = Math.abs(oneWayX * oneWayX + oneWayY * oneWayY - 1) < UNIT;
        if (!(isUnit || oneWayX == 0 && oneWayY == 0)) {
            throw new IllegalArgumentException(
                    "Material.oneWay must be a unit vector or 0 (no unit), was ("
                            + oneWayX
                            + ", "
                            + oneWayY
                            + ")");
        }
    }

    /**
     * A material that is solid all round.
     *
     * @param density kg/m², positive and finite
     * @param friction Coulomb's μ, 0 to 1e9
     * @param elasticity 0 to 1
     * @param rollingResistance m, 0 to 1e9
     * @param surfaceSpeed m/s, up to light's
     * @param drag 1/s, 0 to 1e100
     * @throws IllegalArgumentException naming the field that is out of its range
     */
    public Material(
            double density,
            double friction,
            double elasticity,
            double rollingResistance,
            double surfaceSpeed,
            double drag) {
        this(density, friction, elasticity, rollingResistance, surfaceSpeed, drag, 0, 0);
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
        return with(
                kilogramsPerSquareMetre,
                friction,
                elasticity,
                rollingResistance,
                surfaceSpeed,
                drag);
    }

    /** The same with another Coulomb friction, 0 or more. */
    public Material friction(double coefficient) {
        return with(density, coefficient, elasticity, rollingResistance, surfaceSpeed, drag);
    }

    /** The same with another elasticity, 0 to 1. */
    public Material elasticity(double coefficient) {
        return with(density, friction, coefficient, rollingResistance, surfaceSpeed, drag);
    }

    /** The same with a rolling resistance; counts where {@code RollingResistance} is declared. */
    public Material rollingResistance(double metres) {
        return with(density, friction, elasticity, metres, surfaceSpeed, drag);
    }

    /** The same with a surface speed in m/s; counts where {@code SurfaceSpeed} is declared. */
    public Material surfaceSpeed(double metresPerSecond) {
        return with(density, friction, elasticity, rollingResistance, metresPerSecond, drag);
    }

    /** The same with a drag k in 1/s; counts where {@code Drag} is declared. */
    public Material drag(double perSecond) {
        return with(density, friction, elasticity, rollingResistance, surfaceSpeed, perSecond);
    }

    private Material with(
            double otherDensity,
            double otherFriction,
            double otherElasticity,
            double lever,
            double speed,
            double otherDrag) {
        return new Material(
                otherDensity,
                otherFriction,
                otherElasticity,
                lever,
                speed,
                otherDrag,
                oneWayX,
                oneWayY);
    }

    /**
     * The same with a one-way surface: solid for who lay wholly on the normal's side when they came
     * near, with all parts; whoever comes from elsewhere passes untouched, and is stopped only once
     * it lies on that side. Of a part of a compound, or an edge of a chain, it is that part's.
     *
     * <pre>{@code
     * pool.add(BodyDefinition.fixed(Polygon.box(3, 0.2)).material(wood.oneWay(0, 1))); // a shelf
     * }</pre>
     *
     * @param normalX in the body's frame, of any length
     * @param normalY likewise
     * @throws IllegalArgumentException when the normal is not finite or 0
     */
    public Material oneWay(double normalX, double normalY) {
        double length = StrictMath.hypot(normalX, normalY);
        Require.positive("Material.oneWay length of the normal", length, "no unit");
        return new Material(
                density,
                friction,
                elasticity,
                rollingResistance,
                surfaceSpeed,
                drag,
                normalX / length,
                normalY / length);
    }

    /** Whether the surface is solid on one side alone. */
    public boolean isOneWay() {
        return oneWayX != 0 || oneWayY != 0;
    }
}
