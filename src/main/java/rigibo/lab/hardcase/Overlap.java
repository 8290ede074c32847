package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;
import rigibo.lab.truth.Outline;

import java.util.List;

/**
 * How deep bodies overlap, by brute force and apart from the engine's own measure: every pair,
 * every edge, every corner.
 */
final class Overlap {

    private Outline[] outlines = new Outline[0];

    /** Deepest overlap of all pairs as a share of the smaller width of the two, 0 without any. */
    double deepestShare(List<RigidBody> bodies) {
        int count = bodies.size();
        if (outlines.length < count) {
            outlines = new Outline[count];
        }
        for (int i = 0; i < count; i++) {
            if (outlines[i] == null || outlines[i].shape() != bodies.get(i).shape()) {
                outlines[i] = new Outline(bodies.get(i).shape());
            }
            RigidBody body = bodies.get(i);
            outlines[i].place(body.x(), body.y(), body.angle());
        }
        double deepest = 0;
        for (int i = 0; i < count; i++) {
            for (int j = i + 1; j < count; j++) {
                boolean moves = moves(bodies.get(i)) || moves(bodies.get(j));
                if (moves && outlines[i].isNear(outlines[j])) {
                    deepest = Math.max(deepest, share(outlines[i], outlines[j]));
                }
            }
        }
        return deepest;
    }

    private static boolean moves(RigidBody body) {
        return body.type() == BodyType.DYNAMIC;
    }

    private static double share(Outline a, Outline b) {
        double depth = -a.separation(b);
        double width = Math.min(a.shape().smallestWidth(), b.shape().smallestWidth());
        return Math.max(depth, 0) / width;
    }
}
