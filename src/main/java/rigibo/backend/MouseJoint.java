package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;
import rigibo.backend.setup.Require;

/**
 * Pulls a point of B towards a world point with a damped spring of limited force, as a hand or a
 * mouse pointer drags a body.
 *
 * <pre>{@code
 * RigidBody ground = pool.add(BodyDefinition.fixed(Polygon.box(40, 1)));
 * Joint hand = pool.join(MouseJoint.of(ground, crate, crate.x(), crate.y()));
 * hand.target(3, 4);
 * }</pre>
 *
 * @param a any other body, usually the ground; no reaction acts on it
 * @param b the body that is pulled
 * @param frameB anchor on B
 * @param targetX world x of the target, m
 * @param targetY world y of the target, m, up
 * @param mostForce greatest force, N, positive; may be ∞
 * @param settings the spring
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

    /** Spring of {@link #of}: frequency in Hz and damping ratio. */
    private static final JointSpring HAND = new JointSpring(5, 0.7);

    /**
     * Holds a body at a world point (m) with at most about a thousand times its weight on Earth.
     */
    public static MouseJoint of(RigidBody ground, RigidBody body, double x, double y) {
        JointEnds.require("MouseJoint", ground, body);
        JointFrame frame = JointEnds.frame(body, x, y, body.angle());
        JointSettings settings = JointSettings.NONE.spring(HAND).collideConnected(true);
        return new MouseJoint(ground, body, frame, x, y, MOST_G * body.mass(), settings);
    }

    /** Greatest force of {@link #of} per mass, m/s²: about 1000 g. */
    private static final double MOST_G = 1e4;

    /** A copy with another target, a world point in m. */
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
