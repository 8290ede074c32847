package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.Require;

/** Joint frames of bodies at their present poses. */
final class JointEnds {

    private JointEnds() {}

    /**
     * The joint frame on a body whose origin is now at a world point (m) and whose axis now has the
     * given world angle, rad.
     */
    static JointFrame frame(RigidBody body, double x, double y, double angle) {
        Require.finite("a joint's x", x, "m");
        Require.finite("a joint's y", y, "m");
        Require.finite("a joint's angle", angle, "rad");
        return new JointFrame(body.localX(x, y), body.localY(x, y), angle - body.angle());
    }

    /**
     * Refuses bodies that cannot be joined.
     *
     * @throws IllegalArgumentException when one is null, or both are the same body
     */
    static void require(String joint, RigidBody a, RigidBody b) {
        Require.present(joint + ".a", a);
        Require.present(joint + ".b", b);
        if (a == b) {
            throw new IllegalArgumentException(joint + ".b must be another body than a, was " + b);
        }
    }
}
