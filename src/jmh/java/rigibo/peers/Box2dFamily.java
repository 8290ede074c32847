package rigibo.peers;

import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Outline;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.JointKind;
import rigibo.lab.engine.Link;

import java.util.function.IntToDoubleFunction;

/** The common part of Box2D 2.x and its translations. */
public final class Box2dFamily {

    /** The iterations that the manual suggests: 8 for velocities and 3 for positions. */
    public static final int VELOCITY_ITERATIONS = 8;

    public static final int POSITION_ITERATIONS = 3;

    /** The largest number of corners, which is compiled into the library. */
    private static final int MOST_CORNERS = 8;

    private Box2dFamily() {}

    /**
     * Corner coordinates x₀, y₀, x₁, … relative to the centre of mass, m.
     *
     * @throws UnsupportedOperationException when there are more than 8 corners
     */
    public static float[] corners(Outline polygon) {
        requireRoom(polygon);
        if (polygon.radius() > 0) {
            throw new UnsupportedOperationException("polygons with round corners");
        }
        return xy(polygon.corners(), polygon::cornerX, polygon::cornerY);
    }

    /**
     * Refuses more corners than any version of Box2D allows.
     *
     * @throws UnsupportedOperationException when there are more than 8 corners
     */
    public static void requireRoom(Outline polygon) {
        if (polygon.corners() > MOST_CORNERS) {
            throw new UnsupportedOperationException(
                    "polygons of more than " + MOST_CORNERS + " corners");
        }
    }

    /** Corner coordinates of a chain in its own frame, m. */
    public static float[] corners(Chain chain) {
        return xy(chain.corners(), chain::cornerX, chain::cornerY);
    }

    private static float[] xy(int count, IntToDoubleFunction x, IntToDoubleFunction y) {
        float[] xy = new float[2 * count];
        for (int i = 0; i < count; i++) {
            xy[2 * i] = (float) x.applyAsDouble(i);
            xy[2 * i + 1] = (float) y.applyAsDouble(i);
        }
        return xy;
    }

    /** Corners of the box between the end discs of a capsule, counter-clockwise, m. */
    public static float[] between(Outline capsule) {
        double alongX = capsule.cornerX(1) - capsule.cornerX(0);
        double alongY = capsule.cornerY(1) - capsule.cornerY(0);
        double share = capsule.radius() / Math.hypot(alongX, alongY);
        double acrossX = -share * alongY;
        double acrossY = share * alongX;
        float[] xy = new float[8];
        for (int i = 0; i < 4; i++) {
            int end = i == 1 || i == 2 ? 1 : 0;
            int side = i < 2 ? -1 : 1;
            xy[2 * i] = (float) (capsule.cornerX(end) + side * acrossX);
            xy[2 * i + 1] = (float) (capsule.cornerY(end) + side * acrossY);
        }
        return xy;
    }

    /**
     * The group whose members never collide, a negative number of 16 bits.
     *
     * @throws UnsupportedOperationException when the number is none of 0 to 32767
     */
    public static short group(BodyDefinition body) {
        if (body.group() < 0 || body.group() > Short.MAX_VALUE) {
            throw new UnsupportedOperationException("groups other than 0 to " + Short.MAX_VALUE);
        }
        return (short) -body.group();
    }

    /**
     * Refuses what its joints lack.
     *
     * @throws UnsupportedOperationException naming it
     */
    public static void requireKnown(Link link) {
        boolean isPivot = link.kind() == JointKind.REVOLUTE || link.kind() == JointKind.PRISMATIC;
        if (isPivot && link.settings().spring().isThere()) {
            throw new UnsupportedOperationException("hinges and slides on springs");
        }
        if (!isPivot && link.settings().limits().areAny()) {
            throw new UnsupportedOperationException("limits of rods and wheels");
        }
    }
}
