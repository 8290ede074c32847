package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.Require;

/** Where two bodies are held, as they are placed now. */
final class JointEnds {

    private JointEnds() {}

    /**
     * The frame of a body whose origin is at a world point (m) and whose axis has an angle, rad.
     */
    static JointFrame frame(RigidBody body, double x, double y, double angle) {
        Require.finite("a joint's x", x, "m");
        Require.finite("a joint's y", y, "m");
        Require.finite("a joint's angle", angle, "rad");
        return new JointFrame(body.localX(x, y), body.localY(x, y), angle - body.angle());
    }

    /**
     * Refuses bodies that no joint can be between.
     *
     * @throws IllegalArgumentException when one is missing, or both are one
     */
    static void require(String joint, RigidBody a, RigidBody b) {
        Require.present(joint + ".a", a);
        Require.present(joint + ".b", b);
        if (a == b) {
            throw new IllegalArgumentException(joint + ".b must be another body than a, was " + b);
        }
    }
}
