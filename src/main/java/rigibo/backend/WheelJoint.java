package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Require;

/**
 * A wheel on a suspension strut: the anchor on B stays on an axis of A, and B turns freely. The
 * coordinate is the displacement of that anchor along the axis, m; limits and the spring act on it,
 * while the motor turns B.
 *
 * <pre>{@code
 * double upwards = Math.PI / 2;
 * RigidBody wheel = pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(-1, -0.5));
 * pool.join(WheelJoint.at(crate, wheel, -1, -0.5, upwards).spring(4, 0.7).motor(-10, 30));
 * }</pre>
 *
 * @param a the first body
 * @param b the second body: the wheel
 * @param frameA anchor and axis on A
 * @param frameB anchor on B
 * @param settings limits (m), motor (rad/s, N·m), spring
 */
public record WheelJoint(
        RigidBody a, RigidBody b, JointFrame frameA, JointFrame frameB, JointSettings settings)
        implements JointDefinition {

    /**
     * Checks all parts.
     *
     * @throws IllegalArgumentException when one is missing or out of its range
     */
    public WheelJoint {
        JointEnds.require("WheelJoint", a, b);
        Require.present("WheelJoint.frameA", frameA);
        Require.present("WheelJoint.frameB", frameB);
        Require.present("WheelJoint.settings", settings)
                .requireOnly(
                        "WheelJoint",
                        JointSettings.Part.LIMITS,
                        JointSettings.Part.MOTOR,
                        JointSettings.Part.SPRING);
    }

    /**
     * A wheel on a chassis whose axis runs through a world point (m) along a world angle (rad); the
     * coordinate is 0 at the bodies' present poses.
     */
    public static WheelJoint at(
            RigidBody chassis, RigidBody wheel, double x, double y, double angle) {
        JointEnds.require("WheelJoint", chassis, wheel);
        return new WheelJoint(
                chassis,
                wheel,
                JointEnds.frame(chassis, x, y, angle),
                JointEnds.frame(wheel, x, y, angle),
                JointSettings.NONE);
    }

    @Override
    public WheelJoint with(JointSettings other) {
        return new WheelJoint(a, b, frameA, frameB, other);
    }

    @Override
    public JointKind kind() {
        return JointKind.WHEEL;
    }
}
