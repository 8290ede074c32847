package rigibo.backend.geometry;

/**
 * A stadium, such as a limb, a pill or a link of a chain: all points within a radius of a line
 * segment on its own x axis. The segment's middle is the centre of mass.
 *
 * <pre>{@code
 * pool.add(BodyDefinition.dynamic(new Capsule(0.4, 0.2)).at(0, 2).angle(Math.PI / 2)); // upright
 * }</pre>
 *
 * @param halfLength half the length of the segment, m, zero (a disc) or more, finite
 * @param radius m, positive and finite
 */
public record Capsule(double halfLength, double radius) implements Convex {

    /**
     * Checks the sizes.
     *
     * @throws IllegalArgumentException when a size is out of range
     */
    public Capsule {
        if (!(halfLength >= 0 && halfLength < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "Capsule.halfLength must be zero or more and finite (m), was " + halfLength);
        }
        if (!(radius > 0 && radius < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "Capsule.radius must be positive and finite (m), was " + radius);
        }
        double reach = halfLength + radius;
        double area = 4 * halfLength * radius + Math.PI * radius * radius;
        if (!(area > 0 && area * reach * reach < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "Capsule must have a finite area and inertia, was half as long as "
                            + halfLength
                            + " m with a radius of "
                            + radius
                            + " m");
        }
    }

    @Override
    public ShapeKind kind() {
        return ShapeKind.CAPSULE;
    }

    @Override
    public Outline outline() {
        if (halfLength == 0) {
            return Outline.ofDisc(radius);
        }
        return Outline.of(new double[] {-halfLength, halfLength}, new double[] {0, 0}, radius);
    }

    @Override
    public double area() {
        return 4 * halfLength * radius + Math.PI * radius * radius;
    }

    /**
     * A rectangle with inertia 1/12·m·(a² + b²) between two half discs. The centroid of a half disc
     * lies 4r/3π beyond the rectangle's end, so its inertia about the middle is ½·m·r² + m·h² +
     * 2·m·h·4r/3π.
     */
    @Override
    public MassProperties massProperties(double density) {
        if (halfLength == 0) {
            return new Circle(radius).massProperties(density);
        }
        Polygon.requireDensity(density);
        double h = halfLength;
        double r = radius;
        double between = density * (4 * h * r);
        double ends = density * (Math.PI * r * r);
        double inertia =
                between * (h * h + r * r) / 3
                        + ends * (r * r / 2 + h * h + h * (8 * r / (3 * Math.PI)));
        return new MassProperties(density * area(), inertia, 0, 0);
    }

    @Override
    public double boundingRadius() {
        return halfLength + radius;
    }

    @Override
    public double smallestWidth() {
        return 2 * radius;
    }

    @Override
    public void bounds(double x, double y, double cos, double sin, Aabb out) {
        double reachX = Math.abs(cos) * halfLength + radius;
        double reachY = Math.abs(sin) * halfLength + radius;
        out.set(x - reachX, y - reachY, x + reachX, y + reachY);
    }
}
