package rigibo.backend.storage;

import rigibo.backend.setup.BodyType;

/**
 * Lengths that are stated for bodies of one metre and scale with the smaller movable body of a
 * pair, so that a scene 64 times smaller behaves the same.
 */
public final class PairTolerances {

    /** Gap in m, per metre of body, up to which two bodies count as touching. */
    public static final double TOUCHING_GAP = 1e-3;

    /** Lift in m, per metre of body, below which a rebound is not seen; decides bounce or rest. */
    public static final double INVISIBLE_LIFT = 0.5e-3;

    private PairTolerances() {}

    /** Width in m of the smaller movable body; of the smaller of two where neither is. */
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
     * B, taking the other body as supported: 0 where nothing presses.
     */
    public static double pressingAcceleration(
            Bodies bodies, int a, int b, double normalX, double normalY) {
        double pressA = bodies.accelerationX[a] * normalX + bodies.accelerationY[a] * normalY;
        double pressB = -bodies.accelerationX[b] * normalX - bodies.accelerationY[b] * normalY;
        return Math.max(0, Math.max(pressA, pressB));
    }

    /**
     * Speed in m/s up to which a rebound against a pressing acceleration (m/s²) cannot lift a body
     * of this width (m) visibly: v = √(2·a·d).
     */
    public static double restSpeed(double pressing, double width) {
        return Math.sqrt(2 * pressing * INVISIBLE_LIFT * width);
    }
}
