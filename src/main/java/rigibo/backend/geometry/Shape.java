package rigibo.backend.geometry;

/**
 * The outline of a body in the body's own frame, whose origin is the centre of mass; of a {@link
 * Chain}, which has none, that of its corners. Immutable, so one shape may serve any number of
 * bodies.
 *
 * <pre>{@code
 * Shape shape = Polygon.box(2, 1);
 * System.out.println(shape.area() + " m², reaches " + shape.boundingRadius() + " m");
 * }</pre>
 */
public sealed interface Shape permits Convex, Compound, Chain {

    /** Which shape this is, for switches without a default. */
    ShapeKind kind();

    /** Of how many convex parts, or edges of a chain, it is. */
    int parts();

    /**
     * The outline of a part as collisions see it: a core of corners and a radius, seen from the
     * centre of mass of the whole.
     *
     * @param part from 0
     */
    Outline outline(int part);

    /**
     * Whether a part touches nothing and tells who is inside.
     *
     * @param part from 0
     */
    default boolean isSensor(int part) {
        return false;
    }

    /**
     * Where the origin of the frame in which the shape was stated is, seen from its centre of mass,
     * m along the first axis: 0 of what is stated about its centre, as discs and boxes are.
     */
    default double originX() {
        return 0;
    }

    /** The same along the second axis, m. */
    default double originY() {
        return 0;
    }

    /** Area in m², positive; 0 of a chain. */
    double area();

    /**
     * Mass, inertia and centroid of a plate of this shape.
     *
     * @param density mass per area in kg/m², positive and finite
     * @throws IllegalArgumentException when the density is not positive and finite
     */
    MassProperties massProperties(double density);

    /** Distance in m from the centre of mass to the farthest point of the outline. */
    double boundingRadius();

    /**
     * Smallest width in m between two parallel lines that hold the shape: a disc's diameter, a
     * box's shorter side. Tolerances written for a body of one metre scale with it.
     */
    double smallestWidth();

    /**
     * Writes the axis-aligned bounds of this shape at a pose.
     *
     * @param x centre of mass, m
     * @param y centre of mass, m
     * @param cos cosine of the angle
     * @param sin sine of the angle
     * @param out receives the bounds, m
     */
    void bounds(double x, double y, double cos, double sin, Aabb out);
}
