package rigibo.backend.storage;

import rigibo.backend.setup.BodyType;

/**
 * Tolerances in lengths. They are stated for bodies of one metre and scale with the smaller movable
 * body of a pair, so that a scene 64 times smaller behaves the same.
 */
public final class PairTolerances {

    /** Gap in m, per metre of body, up to which two bodies count as touching. */
    public static final double TOUCHING_GAP = 1e-3;

    /**
     * Lift in m, per metre of body, below which a rebound cannot be seen; decides between bounce
     * and rest.
     */
    public static final double INVISIBLE_LIFT = 0.5e-3;

    private PairTolerances() {}

    /**
     * Width in m of the movable body of a pair; of the smaller body if both or neither can be
     * moved.
     */
    public static double width(Bodies bodies, int a, int b) {
        boolean movesA = bodies.type[a] == BodyType.DYNAMIC;
        boolean movesB = bodies.type[b] == BodyType.DYNAMIC;
        if (movesA != movesB) {
            return bodies.smallestWidth[movesA ? a : b];
        }
        return Math.min(bodies.smallestWidth[a], bodies.smallestWidth[b]);
    }

    /**
     * Acceleration in m/s² with which the effects press a pair together along its normal from A to
     * B, as if the other body were supported; 0 where nothing presses.
     */
    public static double pressingAcceleration(
            Bodies bodies, int a, int b, double normalX, double normalY) {
        double pressA = along(bodies.accelerationX[a], bodies.accelerationY[a], normalX, normalY);
        double pressB = along(bodies.accelerationX[b], bodies.accelerationY[b], -normalX, -normalY);
        return Math.max(0, Math.max(pressA, pressB));
    }

    /**
     * Whether a force in N between A and B is more than round-off: it accelerates them by more than
     * the round-off of their own accelerations.
     */
    public static boolean isPressing(Bodies bodies, int a, int b, double force) {
        double weights =
                (Math.abs(bodies.accelerationX[a]) + Math.abs(bodies.accelerationY[a]))
                        + (Math.abs(bodies.accelerationX[b]) + Math.abs(bodies.accelerationY[b]));
        return force * (bodies.inverseMass[a] + bodies.inverseMass[b]) > RoundOff.OF_SUMS * weights;
    }

    /**
     * Component of an acceleration (ax, ay) in m/s² along a unit normal; 0 where it is no more than
     * round-off of the normal. Two boxes that fall side by side do not press on each other, though
     * their common normal is horizontal only up to a few ulp.
     */
    public static double along(double ax, double ay, double normalX, double normalY) {
        double component = ax * normalX + ay * normalY;
        double least = RoundOff.OF_SUMS * (Math.abs(ax) + Math.abs(ay));
        return Math.abs(component) > least ? component : 0;
    }

    /**
     * Speed in m/s up to which a rebound cannot visibly lift a body of this width (m) against a
     * pressing acceleration (m/s²): v = √(2·a·d).
     */
    public static double restSpeed(double pressing, double width) {
        return Math.sqrt(2 * pressing * INVISIBLE_LIFT * width);
    }
}
