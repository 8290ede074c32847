package rigibo.backend.storage;

/** How fast the points of a pair move along its normal from A to B, m/s, where bodies turn. */
public final class PointSpeeds {

    private PointSpeeds() {}

    /** Speed at which the bodies part at a point; negative where they close. */
    public static double parting(Bodies bodies, Pairs pairs, int pair, int point) {
        return along(bodies, pairs, pair, point, pairs.bodyB[pair])
                - along(bodies, pairs, pair, point, pairs.bodyA[pair]);
    }

    /** Speed along the normal of what a body has at a point. */
    public static double along(Bodies bodies, Pairs pairs, int pair, int point, int slot) {
        return pairs.normalX[pair] * velocityX(bodies, pairs, point, slot)
                + pairs.normalY[pair] * velocityY(bodies, pairs, point, slot);
    }

    /** Velocity east of what a body has at a point. */
    public static double velocityX(Bodies bodies, Pairs pairs, int point, int slot) {
        double arm = pairs.pointY[point] - bodies.y[slot];
        return bodies.velocityX[slot] - bodies.spinOf(slot) * arm;
    }

    /** Velocity north of what a body has at a point. */
    public static double velocityY(Bodies bodies, Pairs pairs, int point, int slot) {
        double arm = pairs.pointX[point] - bodies.x[slot];
        return bodies.velocityY[slot] + bodies.spinOf(slot) * arm;
    }
}
