package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Require;

/**
 * A slide: B does not turn relative to A, and the anchor on B stays on an axis of A. The coordinate
 * is the displacement of that anchor along the axis, m; a spring pulls it to 0.
 *
 * <pre>{@code
 * RigidBody wall = pool.add(BodyDefinition.fixed(Polygon.box(0.2, 3)));
 * double upwards = Math.PI / 2;
 * pool.join(PrismaticJoint.along(wall, crate, 0, 2, upwards).limits(0, 3).motor(1, 500));
 * }</pre>
 *
 * @param a the first body
 * @param b the second body, whose motion relative to A is the coordinate
 * @param frameA anchor and axis on A
 * @param frameB anchor on B
 * @param settings limits (m), motor (m/s, N), spring
 */
public record PrismaticJoint(
        RigidBody a, RigidBody b, JointFrame frameA, JointFrame frameB, JointSettings settings)
        implements JointDefinition {

    /**
     * Checks all parts.
     *
     * @throws IllegalArgumentException when one is missing or out of its range
     */
    public PrismaticJoint {
        JointEnds.require("PrismaticJoint", a, b);
        Require.present("PrismaticJoint.frameA", frameA);
        Require.present("PrismaticJoint.frameB", frameB);
        Require.present("PrismaticJoint.settings", settings)
                .requireOnly(
                        "PrismaticJoint",
                        JointSettings.Part.LIMITS,
                        JointSettings.Part.MOTOR,
                        JointSettings.Part.SPRING);
    }

    /**
     * A slide through a world point (m) along a world angle (rad), whose coordinate is 0 at the
     * bodies' present poses.
     */
    public static PrismaticJoint along(RigidBody a, RigidBody b, double x, double y, double angle) {
        JointEnds.require("PrismaticJoint", a, b);
        return new PrismaticJoint(
                a,
                b,
                JointEnds.frame(a, x, y, angle),
                JointEnds.frame(b, x, y, angle),
                JointSettings.NONE);
    }

    @Override
    public PrismaticJoint with(JointSettings other) {
        return new PrismaticJoint(a, b, frameA, frameB, other);
    }

    @Override
    public JointKind kind() {
        return JointKind.PRISMATIC;
    }
}
