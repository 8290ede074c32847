package rigibo.backend.setup;

import rigibo.backend.geometry.Length;

/**
 * The material of a body. For a contact of two bodies, friction mixes as √(μₐ·μ_b), elasticity as
 * max(eₐ, e_b), rolling resistance as max(cₐ, c_b), and surface speeds add.
 *
 * <pre>{@code
 * Material oak = new Material(700, 0.4, 0.3); // kg/m², Coulomb's friction, elasticity
 * Material belt = oak.surfaceSpeed(-2); // m/s: carries to the right
 * }</pre>
 *
 * @param density kg/m², positive and finite
 * @param friction Coulomb's μ, 0 to 1e9; ice 0.03, wood 0.4, rubber 0.9
 * @param elasticity Newton's coefficient of restitution e: 0 (no rebound) to 1 (a dropped ball
 *     returns to its height)
 * @param rollingResistance lever c in m, 0 to 1e9: rolling is braked by a torque of up to c·N, N
 *     being the normal force
 * @param surfaceSpeed speed of the running outline in m/s, positive counter-clockwise, up to the
 *     speed of light: a conveyor belt
 * @param drag k in 1/s, 0 to 1e100: the body is braked by the acceleration k·v
 * @param oneWayX x of the unit normal of a one-way surface in the body's frame; see {@link #oneWay}
 * @param oneWayY y of that normal; both are 0 for a surface that is solid on all sides
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

    /**
     * Highest friction accepted, no unit: far beyond sticking, and squares of loads stay finite.
     */
    public static final double MOST_FRICTION = 1e9;

    /** Longest rolling lever accepted, m. */
    public static final double MOST_ROLLING_RESISTANCE = 1e9;

    /** Highest surface speed accepted, m/s: that of light, as for bodies. */
    public static final double MOST_SURFACE_SPEED = 299_792_458;

    /** Strongest drag accepted, 1/s: it stops any body within any step. */
    public static final double MOST_DRAG = 1e100;

    /** Tolerance of the square of a unit vector's length, which is 1. */
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
     * A material that is solid on all sides.
     *
     * @param density kg/m², positive and finite
     * @param friction Coulomb's μ, 0 to 1e9
     * @param elasticity 0 to 1
     * @param rollingResistance lever c, m, 0 to 1e9
     * @param surfaceSpeed m/s, within ± the speed of light, positive counter-clockwise
     * @param drag k, 1/s, 0 to 1e100
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

    /** A copy with another density, kg/m², positive. */
    public Material density(double kilogramsPerSquareMetre) {
        return with(
                kilogramsPerSquareMetre,
                friction,
                elasticity,
                rollingResistance,
                surfaceSpeed,
                drag);
    }

    /** A copy with another coefficient of friction, 0 to 1e9. */
    public Material friction(double coefficient) {
        return with(density, coefficient, elasticity, rollingResistance, surfaceSpeed, drag);
    }

    /** A copy with another elasticity, 0 to 1. */
    public Material elasticity(double coefficient) {
        return with(density, friction, coefficient, rollingResistance, surfaceSpeed, drag);
    }

    /** A copy with another rolling lever, m; it needs the effect {@code RollingResistance}. */
    public Material rollingResistance(double metres) {
        return with(density, friction, elasticity, metres, surfaceSpeed, drag);
    }

    /** A copy with another surface speed, m/s; it needs the effect {@code SurfaceSpeed}. */
    public Material surfaceSpeed(double metresPerSecond) {
        return with(density, friction, elasticity, rollingResistance, metresPerSecond, drag);
    }

    /** A copy with another drag k, 1/s; it needs the effect {@code Drag}. */
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
     * A copy with a one-way surface. The surface is solid only for a body that lay wholly, with all
     * its parts, on the side the normal points to when it came near. Any other body passes through
     * until it lies wholly on that side. For a part of a compound or an edge of a chain this holds
     * for that part alone.
     *
     * <pre>{@code
     * pool.add(BodyDefinition.fixed(Polygon.box(3, 0.2)).material(wood.oneWay(0, 1))); // a shelf
     * }</pre>
     *
     * @param normalX x of the normal in the body's frame; the normal may have any length but 0
     * @param normalY y of the normal in the body's frame
     * @throws IllegalArgumentException when the normal is not finite or 0
     */
    public Material oneWay(double normalX, double normalY) {
        double length = Length.hypot(normalX, normalY);
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

    /** Whether the surface is one-way. */
    public boolean isOneWay() {
        return oneWayX != 0 || oneWayY != 0;
    }
}
