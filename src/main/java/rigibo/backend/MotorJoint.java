package rigibo.backend;

import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Require;

/**
 * Drives B to a velocity relative to A, with limited force and torque: a motor without an axle.
 * With velocity 0 it acts as dry friction, for instance of a floor seen from above.
 *
 * <pre>{@code
 * RigidBody ground = pool.add(BodyDefinition.fixed(Polygon.box(40, 40)).at(100, 0));
 * pool.join(MotorJoint.friction(ground, crate, 50, 10)); // N, N·m
 * }</pre>
 *
 * @param a the first body
 * @param b the second body
 * @param velocityX wanted velocity of B's centre of mass relative to the point of A at the same
 *     place, along A's x axis, m/s
 * @param velocityY wanted velocity along A's y axis, m/s
 * @param angularVelocity wanted angular velocity of B relative to A, rad/s, counter-clockwise
 * @param mostForce greatest force, N, 0 or more; may be ∞
 * @param mostTorque greatest torque, N·m, 0 or more; may be ∞
 * @param settings breaking loads and whether the two bodies collide
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

    /** Dry friction with a greatest force (N) and torque (N·m) between bodies that may collide. */
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
