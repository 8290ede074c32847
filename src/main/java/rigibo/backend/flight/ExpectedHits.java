package rigibo.backend.flight;

import rigibo.backend.collision.distance.Motion;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Hits;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/**
 * Hits of bodies that join a pile before they touch what they then strike. The pile's solver tells
 * only impacts that may rebound; others are told as expected here, if the two press each other.
 */
final class ExpectedHits {

    private final Pairs pairs;
    private final Trajectories paths;
    private final Hits hits;
    private final Motion motionA = new Motion();
    private final Motion motionB = new Motion();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    ExpectedHits(DataStorage data, Trajectories paths) {
        pairs = data.pairs;
        this.paths = paths;
        hits = data.noteHits();
    }

    /**
     * Expects the hit of a pair that was measured at a time (s) within a step of dt seconds, by the
     * predicted motions of both. They may close faster than these, by {@code more} m/s.
     */
    void expect(int pair, double time, double more, double dt) {
        paths.load(pairs.bodyA[pair], motionA);
        paths.load(pairs.bodyB[pair], motionB);
        motionA.poseAt(time, poseA);
        motionB.poseAt(time, poseB);
        int last = 2 * pair + pairs.points[pair] - 1;
        double closing = more + Math.max(closing(pair, 2 * pair), closing(pair, last));
        if (closing > 0) {
            double later = Math.min(dt - time, Math.max(0, pairs.gap(pair)) / closing);
            hits.expect(
                    pair,
                    (pairs.pointX[2 * pair] + pairs.pointX[last]) / 2 + later * motionA.velocityX,
                    (pairs.pointY[2 * pair] + pairs.pointY[last]) / 2 + later * motionA.velocityY,
                    closing,
                    time + later);
        }
    }

    /** Closing speed of both bodies at a point of their contact, m/s. */
    private double closing(int pair, int point) {
        double x = pairs.pointX[point];
        double y = pairs.pointY[point];
        double turnX = motionB.spin * (y - poseB.y) - motionA.spin * (y - poseA.y);
        double turnY = motionB.spin * (x - poseB.x) - motionA.spin * (x - poseA.x);
        return -PairTolerances.along(
                motionB.velocityX - motionA.velocityX - turnX,
                motionB.velocityY - motionA.velocityY + turnY,
                pairs.normalX[pair],
                pairs.normalY[pair]);
    }
}
