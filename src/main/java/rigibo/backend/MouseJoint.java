package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;
import rigibo.backend.setup.Require;

/**
 * Pulls a point of B to a point of the world by a damped spring, with no more than a force: what a
 * hand does.
 *
 * <pre>{@code
 * RigidBody ground = pool.add(BodyDefinition.fixed(Polygon.box(40, 1)));
 * Joint hand = pool.join(MouseJoint.of(ground, crate, crate.x(), crate.y()));
 * hand.target(3, 4);
 * }</pre>
 *
 * @param a any other body, mostly the ground; it takes no reaction
 * @param b the body that is pulled
 * @param frameB where it is held
 * @param targetX world x to pull it to, m
 * @param targetY world y, m
 * @param mostForce N, positive; may be ∞
 * @param settings spring
 */
public record MouseJoint(
        RigidBody a,
        RigidBody b,
        JointFrame frameB,
        double targetX,
        double targetY,
        double mostForce,
        JointSettings settings)
        implements JointDefinition {

    /**
     * Checks all parts.
     *
     * @throws IllegalArgumentException when one is missing or out of its range
     */
    public MouseJoint {
        JointEnds.require("MouseJoint", a, b);
        Require.present("MouseJoint.frameB", frameB);
        Require.finite("MouseJoint.targetX", targetX, "m");
        Require.finite("MouseJoint.targetY", targetY, "m");
        if (!(mostForce > 0)) {
            throw new IllegalArgumentException(
                    "MouseJoint.mostForce must be positive (N), was " + mostForce);
        }
        Require.present("MouseJoint.settings", settings)
                .requireOnly("MouseJoint", JointSettings.Part.SPRING);
    }

    /** Usual spring of a hand. */
    private static final JointSpring HAND = new JointSpring(5, 0.7);

    /** Holds a body at a world point in m, with up to a thousand times its weight on Earth. */
    public static MouseJoint of(RigidBody ground, RigidBody body, double x, double y) {
        JointEnds.require("MouseJoint", ground, body);
        JointFrame frame = JointEnds.frame(body, x, y, body.angle());
        JointSettings settings = JointSettings.NONE.spring(HAND).collideConnected(true);
        return new MouseJoint(ground, body, frame, x, y, MOST_G * body.mass(), settings);
    }

    /** m/s². */
    private static final double MOST_G = 1e4;

    /** This joint, pulled to another world point in m. */
    public MouseJoint target(double x, double y) {
        return new MouseJoint(a, b, frameB, x, y, mostForce, settings);
    }

    @Override
    public MouseJoint with(JointSettings other) {
        return new MouseJoint(a, b, frameB, targetX, targetY, mostForce, other);
    }

    @Override
    public JointKind kind() {
        return JointKind.MOUSE;
    }
}
