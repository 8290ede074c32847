package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Require;

/**
 * A rope from an anchor on A over two fixed world points to an anchor on B; it pulls and never
 * pushes. The rope's length on A's side plus {@code ratio} times its length on B's side is never
 * more than {@code length}. A ratio other than 1 makes it a block and tackle.
 *
 * <pre>{@code
 * pool.join(PulleyJoint.over(crate, door, 10)); // over two points, 10 m above the bodies
 * }</pre>
 *
 * @param a the first body
 * @param b the second body
 * @param frameA anchor on A
 * @param frameB anchor on B
 * @param groundAX world x of the fixed point above A, m
 * @param groundAY world y of the fixed point above A, m, up
 * @param groundBX world x of the fixed point above B, m
 * @param groundBY world y of the fixed point above B, m, up
 * @param ratio weight of the rope's length on B's side, no unit, positive
 * @param length greatest value of the weighted length, m, positive
 * @param settings breaking loads and whether the two bodies collide
 */
public record PulleyJoint(
        RigidBody a,
        RigidBody b,
        JointFrame frameA,
        JointFrame frameB,
        double groundAX,
        double groundAY,
        double groundBX,
        double groundBY,
        double ratio,
        double length,
        JointSettings settings)
        implements JointDefinition {

    /**
     * Checks all parts.
     *
     * @throws IllegalArgumentException when one is missing or out of its range
     */
    public PulleyJoint {
        JointEnds.require("PulleyJoint", a, b);
        Require.present("PulleyJoint.frameA", frameA);
        Require.present("PulleyJoint.frameB", frameB);
        Require.finite("PulleyJoint.groundAX", groundAX, "m");
        Require.finite("PulleyJoint.groundAY", groundAY, "m");
        Require.finite("PulleyJoint.groundBX", groundBX, "m");
        Require.finite("PulleyJoint.groundBY", groundBY, "m");
        Require.positive("PulleyJoint.ratio", ratio, "no unit");
        Require.positive("PulleyJoint.length", length, "m");
        Require.present("PulleyJoint.settings", settings).requireOnly("PulleyJoint");
    }

    /**
     * A taut rope from A's centre of mass straight up to a height, across at that height, and
     * straight down to B's centre of mass, with a ratio of 1.
     *
     * @param height world y of the two fixed points, m
     */
    public static PulleyJoint over(RigidBody a, RigidBody b, double height) {
        JointEnds.require("PulleyJoint", a, b);
        return new PulleyJoint(
                a,
                b,
                JointFrame.CENTRE,
                JointFrame.CENTRE,
                a.x(),
                height,
                b.x(),
                height,
                1,
                Math.abs(height - a.y()) + Math.abs(height - b.y()),
                JointSettings.NONE);
    }

    @Override
    public PulleyJoint with(JointSettings other) {
        return new PulleyJoint(
                a, b, frameA, frameB, groundAX, groundAY, groundBX, groundBY, ratio, length, other);
    }

    @Override
    public JointKind kind() {
        return JointKind.PULLEY;
    }
}
