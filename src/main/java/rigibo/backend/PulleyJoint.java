package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Require;

/**
 * A rope over two fixed points of the world, from a point of A to a point of B, which pulls and
 * never pushes: its coordinate is the length on A's side plus {@code ratio} times that on B's, m,
 * and never more than {@code length}. A ratio other than 1 is a block and tackle.
 *
 * <pre>{@code
 * pool.join(PulleyJoint.over(crate, door, 10)); // over two points, 10 m above the bodies
 * }</pre>
 *
 * @param a the first body
 * @param b the second body
 * @param frameA where the rope holds A
 * @param frameB where it holds B
 * @param groundAX world x of the point over A, m
 * @param groundAY world y, m
 * @param groundBX world x of the point over B, m
 * @param groundBY world y, m
 * @param ratio positive
 * @param length m, positive
 * @param settings breaking loads and whether the two meet
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
     * A taut rope from a body's centre of mass straight up to the height of a world point, over two
     * points there, and down to the other's centre.
     *
     * @param height of the two points, world y, m
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
