package rigibo.backend.geometry;

/**
 * The shape of a body in the body's own frame. The origin of that frame is the centre of mass; for
 * a {@link Chain}, which has no mass, it is the origin in which the corners were stated. Immutable,
 * so one shape may serve any number of bodies.
 *
 * <pre>{@code
 * Shape shape = Polygon.box(2, 1);
 * System.out.println(shape.area() + " m², reaches " + shape.boundingRadius() + " m");
 * }</pre>
 */
public sealed interface Shape permits Convex, Compound, Chain {

    /** The kind of this shape, for switches without a default. */
    ShapeKind kind();

    /** Number of convex parts, or of edges of a chain. */
    int parts();

    /**
     * The outline of a part for collision detection, relative to the centre of mass of the whole
     * shape.
     *
     * @param part from 0
     */
    Outline outline(int part);

    /**
     * Whether a part is a sensor, which touches nothing and reports the bodies inside it.
     *
     * @param part from 0
     */
    default boolean isSensor(int part) {
        return false;
    }

    /**
     * The x, relative to the centre of mass and in m, of the origin of the frame in which the shape
     * was stated: 0 for shapes stated about their centre, such as discs and boxes.
     */
    default double originX() {
        return 0;
    }

    /** The y of that origin, m. */
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
     * Smallest distance in m between two parallel lines that enclose the shape: a disc's diameter,
     * a box's shorter side. Tolerances stated for a body of one metre scale with it.
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
