package rigibo.backend.geometry;

/** Checks that a list of points is a convex polygon, and names what is wrong with it. */
final class PolygonCheck {

    /**
     * Smallest sine of the turn between neighbouring edges. With a smaller one both are the same
     * edge to double precision, and the corner between them would only add a contact point that
     * jumps.
     */
    static final double LEAST_SINE = 1e-10;

    private PolygonCheck() {}

    static void requireConvex(double[] xy) {
        requireCount("Polygon.of", xy);
        requireFinite("Polygon.of", xy);
        int count = xy.length / 2;
        double turned = 0;
        for (int i = 0; i < count; i++) {
            turned += turnAt(xy, i, (i + 1) % count, (i + 2) % count);
        }
        // A star also turns left at every corner, but by more than one full turn in all.
        if (turned > 3 * Math.PI) {
            throw new IllegalArgumentException(
                    "Polygon.of corners must go round once, they go round "
                            + Math.round(turned / (2 * Math.PI))
                            + " times");
        }
        MassProperties plate = MassProperties.ofPolygon(1, xy);
        if (!(plate.mass() > 0 && plate.inertia() > 0 && finite(plate.inertia()))) {
            throw new IllegalArgumentException(
                    "Polygon.of must have a positive, finite area and inertia, area was "
                            + plate.mass()
                            + " m²");
        }
    }

    static void requirePresent(String argument, Object value) {
        if (value == null) {
            throw new IllegalArgumentException(argument + " must be present, was null");
        }
    }

    static void requireCount(String maker, double[] xy) {
        if (xy.length % 2 != 0 || xy.length < 6 || xy.length > 2 * Polygon.MAX_CORNERS) {
            throw new IllegalArgumentException(
                    maker
                            + " takes x, y pairs of 3 to "
                            + Polygon.MAX_CORNERS
                            + " corners, was "
                            + xy.length
                            + " numbers");
        }
    }

    /**
     * Checks the number of corners of a hull; fewer than three mean that all points lie on one
     * line.
     */
    static void requireHull(double[] corners) {
        int count = corners.length / 2;
        if (count < 3 || count > Polygon.MAX_CORNERS) {
            throw new IllegalArgumentException(
                    "Polygon.hull must have 3 to "
                            + Polygon.MAX_CORNERS
                            + " corners, had "
                            + count
                            + (count < 3 ? ": all points lie on one line" : ""));
        }
    }

    static void requireFinite(String maker, double[] xy) {
        for (int i = 0; i < xy.length; i++) {
            if (!finite(xy[i])) {
                throw new IllegalArgumentException(
                        maker + " corner " + i / 2 + " must be finite (m), was " + xy[i]);
            }
        }
    }

    /** Left turn at corner b, rad; rejects repeated, collinear and reflex corners. */
    private static double turnAt(double[] xy, int a, int b, int c) {
        double ux = xy[2 * b] - xy[2 * a];
        double uy = xy[2 * b + 1] - xy[2 * a + 1];
        double wx = xy[2 * c] - xy[2 * b];
        double wy = xy[2 * c + 1] - xy[2 * b + 1];
        double lengths = Math.sqrt(ux * ux + uy * uy) * Math.sqrt(wx * wx + wy * wy);
        if (!(lengths > 0)) {
            throw new IllegalArgumentException(
                    "Polygon.of corner " + b + " is repeated at " + at(xy, b));
        }
        double sine = (ux * wy - uy * wx) / lengths;
        if (!(sine > LEAST_SINE)) {
            throw new IllegalArgumentException(
                    "Polygon.of corner "
                            + b
                            + " at "
                            + at(xy, b)
                            + (sine < -LEAST_SINE
                                    ? " is reflex: corners must be convex and counter-clockwise"
                                    : " lies on the line through its neighbours"));
        }
        return Angle.atan2(sine, (ux * wx + uy * wy) / lengths);
    }

    static String at(double[] xy, int i) {
        return "(" + xy[2 * i] + ", " + xy[2 * i + 1] + ") m";
    }

    private static boolean finite(double value) {
        return Math.abs(value) < Double.POSITIVE_INFINITY;
    }
}
