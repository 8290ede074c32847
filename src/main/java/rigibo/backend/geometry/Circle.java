package rigibo.backend.geometry;

/**
 * A disc with its centre of mass at its centre.
 *
 * <pre>{@code
 * pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(0, 3)); // a disc of 1 m
 * }</pre>
 *
 * @param radius m, positive and finite
 */
public record Circle(double radius) implements Convex {

    /**
     * Checks the radius.
     *
     * @throws IllegalArgumentException when the radius is not positive and finite
     */
    public Circle {
        if (!(radius > 0 && radius < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "Circle.radius must be positive and finite (m), was " + radius);
        }
        double area = Math.PI * radius * radius;
        if (!(area > 0 && area * radius * radius < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "Circle.radius must give a finite area and inertia (m), was " + radius);
        }
    }

    @Override
    public ShapeKind kind() {
        return ShapeKind.CIRCLE;
    }

    @Override
    public Outline outline() {
        return Outline.ofDisc(radius);
    }

    @Override
    public double area() {
        return Math.PI * radius * radius;
    }

    /** A disc's inertia is ½·m·r². */
    @Override
    public MassProperties massProperties(double density) {
        Polygon.requireDensity(density);
        double mass = density * area();
        return new MassProperties(mass, mass * radius * radius / 2, 0, 0);
    }

    @Override
    public double boundingRadius() {
        return radius;
    }

    @Override
    public double smallestWidth() {
        return 2 * radius;
    }

    @Override
    public void bounds(double x, double y, double cos, double sin, Aabb out) {
        out.set(x - radius, y - radius, x + radius, y + radius);
    }
}
