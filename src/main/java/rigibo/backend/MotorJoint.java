package rigibo.backend;

import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Require;

/**
 * Drives B against A to a velocity, with no more than a force and a torque: a motor without an
 * axle, or, at rest, the friction of a floor that is looked at from above.
 *
 * <pre>{@code
 * RigidBody ground = pool.add(BodyDefinition.fixed(Polygon.box(40, 40)).at(100, 0));
 * pool.join(MotorJoint.friction(ground, crate, 50, 10)); // N, N·m
 * }</pre>
 *
 * @param a the first body
 * @param b the second body
 * @param velocityX of B's centre of mass against A's point there, along A's first axis, m/s
 * @param velocityY along its second axis, m/s
 * @param angularVelocity of B against A, rad/s, counter-clockwise
 * @param mostForce N, 0 or more; may be ∞
 * @param mostTorque N·m, likewise
 * @param settings breaking loads and whether the two meet
 */
public record MotorJoint(
        RigidBody a,
        RigidBody b,
        double velocityX,
        double velocityY,
        double angularVelocity,
        double mostForce,
        double mostTorque,
        JointSettings settings)
        implements JointDefinition {

    /**
     * Checks all parts.
     *
     * @throws IllegalArgumentException when one is missing or out of its range
     */
    public MotorJoint {
        JointEnds.require("MotorJoint", a, b);
        Require.finite("MotorJoint.velocityX", velocityX, "m/s");
        Require.finite("MotorJoint.velocityY", velocityY, "m/s");
        Require.finite("MotorJoint.angularVelocity", angularVelocity, "rad/s");
        double most = Double.POSITIVE_INFINITY;
        Require.within("MotorJoint.mostForce", mostForce, 0, most, "N");
        Require.within("MotorJoint.mostTorque", mostTorque, 0, most, "N·m");
        Require.present("MotorJoint.settings", settings).requireOnly("MotorJoint");
    }

    /** Dry friction of so many N and N·m, and bodies that meet each other. */
    public static MotorJoint friction(RigidBody a, RigidBody b, double force, double torque) {
        JointSettings settings = JointSettings.NONE.collideConnected(true);
        return new MotorJoint(a, b, 0, 0, 0, force, torque, settings);
    }

    @Override
    public MotorJoint with(JointSettings other) {
        return new MotorJoint(
                a, b, velocityX, velocityY, angularVelocity, mostForce, mostTorque, other);
    }

    @Override
    public JointKind kind() {
        return JointKind.MOTOR;
    }
}
