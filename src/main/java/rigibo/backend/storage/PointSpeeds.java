package rigibo.backend.storage;

/** Velocities of the material points of both bodies at a contact point of a pair, m/s. */
public final class PointSpeeds {

    private PointSpeeds() {}

    /** Relative speed of the bodies along the normal at a point; negative when they approach. */
    public static double parting(Bodies bodies, Pairs pairs, int pair, int point) {
        return along(bodies, pairs, pair, point, pairs.bodyB[pair])
                - along(bodies, pairs, pair, point, pairs.bodyA[pair]);
    }

    /** Velocity of a body's material point along the pair's normal from A to B. */
    public static double along(Bodies bodies, Pairs pairs, int pair, int point, int slot) {
        return pairs.normalX[pair] * velocityX(bodies, pairs, point, slot)
                + pairs.normalY[pair] * velocityY(bodies, pairs, point, slot);
    }

    /** Velocity of a body's material point along x. */
    public static double velocityX(Bodies bodies, Pairs pairs, int point, int slot) {
        double arm = pairs.pointY[point] - bodies.y[slot];
        return bodies.velocityX[slot] - bodies.spinOf(slot) * arm;
    }

    /** Velocity of a body's material point along y. */
    public static double velocityY(Bodies bodies, Pairs pairs, int point, int slot) {
        double arm = pairs.pointX[point] - bodies.x[slot];
        return bodies.velocityY[slot] + bodies.spinOf(slot) * arm;
    }
}
