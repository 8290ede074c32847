package rigibo.backend.collision;

import rigibo.backend.collision.manifold.Collider;
import rigibo.backend.collision.manifold.Manifold;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/**
 * Replaces the manifold of two overlapping parts if it leads through a face that another part
 * covers, since such a face is no way out of a body. A shallow body leaves through the nearest face
 * beside the seam; a deep one, through any other face.
 */
final class WayOut {

    private final Bodies bodies;
    private final Pairs pairs;
    private final Collider collider;
    private final Manifold manifold;

    WayOut(DataStorage data, Collider collider, Manifold manifold) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.collider = collider;
        this.manifold = manifold;
    }

    /** Checks the manifold of a pair that was filled at these poses with this reach, m. */
    void take(int pair, Pose atA, Pose atB, double reach) {
        Outline outlineA = bodies.outline[pairs.shapeA(pair)];
        Outline outlineB = bodies.outline[pairs.shapeB(pair)];
        double width = PairTolerances.width(bodies, pairs.bodyA[pair], pairs.bodyB[pair]);
        double deepest = manifold.count > 0 ? manifold.deepest() : 0;
        boolean isDeep = deepest < -PartSeams.DEEP * width;
        if (isDeep || deepest < 0 && leadsInside(outlineA, atA, outlineB, atB)) {
            collider.leave(outlineA, atA, outlineB, atB, reach, manifold);
        }
    }

    private boolean leadsInside(Outline outlineA, Pose atA, Outline outlineB, Pose atB) {
        double x = manifold.normalX;
        double y = manifold.normalY;
        return PartSeams.leadsInside(outlineA, atA, x, y)
                || PartSeams.leadsInside(outlineB, atB, -x, -y);
    }
}
