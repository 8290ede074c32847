package rigibo.peers;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

/** What Box2D 2.x and its translations have in common. */
public final class Box2dFamily {

    /** What the manual suggests: 8 for velocities and 3 for positions. */
    public static final int VELOCITY_ITERATIONS = 8;

    public static final int POSITION_ITERATIONS = 3;

    /** A constant that is compiled into every loop over corners, and cannot be raised. */
    private static final int MOST_CORNERS = 8;

    private Box2dFamily() {}

    /**
     * Corner coordinates x₀, y₀, x₁, … relative to the centre of mass, m.
     *
     * @throws UnsupportedOperationException when there are more than 8 corners
     */
    public static float[] corners(Polygon polygon) {
        if (polygon.corners() > MOST_CORNERS) {
            throw new UnsupportedOperationException(
                    "polygons of more than " + MOST_CORNERS + " corners");
        }
        float[] xy = new float[2 * polygon.corners()];
        for (int i = 0; i < polygon.corners(); i++) {
            xy[2 * i] = (float) polygon.cornerX(i);
            xy[2 * i + 1] = (float) polygon.cornerY(i);
        }
        return xy;
    }

    /**
     * The group whose members never collide: those have negative numbers, of 16 bits.
     *
     * @throws UnsupportedOperationException when the number is none of 0 to 32767
     */
    public static short group(BodyDefinition body) {
        if (body.group() < 0 || body.group() > Short.MAX_VALUE) {
            throw new UnsupportedOperationException("groups other than 0 to " + Short.MAX_VALUE);
        }
        return (short) -body.group();
    }
}
