package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Require;

/**
 * A hinge: the anchors on A and B stay together. The coordinate is the angle from A's axis to B's,
 * rad, counter-clockwise; a spring pulls it to 0.
 *
 * <pre>{@code
 * RigidBody wall = pool.add(BodyDefinition.fixed(Polygon.box(0.2, 3)));
 * Joint hinge = pool.join(RevoluteJoint.at(wall, door, 0, 2).limits(-1.5, 1.5).motor(0, 4));
 * pool.step(1 / 60.0);
 * System.out.println(hinge.angle());
 * }</pre>
 *
 * @param a the first body
 * @param b the second body, whose motion relative to A is the coordinate
 * @param frameA anchor and axis on A
 * @param frameB anchor and axis on B
 * @param settings limits (rad), motor (rad/s, N·m), spring
 */
public record RevoluteJoint(
        RigidBody a, RigidBody b, JointFrame frameA, JointFrame frameB, JointSettings settings)
        implements JointDefinition {

    /**
     * Checks all parts.
     *
     * @throws IllegalArgumentException when one is missing or out of its range
     */
    public RevoluteJoint {
        JointEnds.require("RevoluteJoint", a, b);
        Require.present("RevoluteJoint.frameA", frameA);
        Require.present("RevoluteJoint.frameB", frameB);
        Require.present("RevoluteJoint.settings", settings)
                .requireOnly(
                        "RevoluteJoint",
                        JointSettings.Part.LIMITS,
                        JointSettings.Part.MOTOR,
                        JointSettings.Part.SPRING);
    }

    /** A hinge at a world point (m), whose angle is 0 at the bodies' present poses. */
    public static RevoluteJoint at(RigidBody a, RigidBody b, double x, double y) {
        JointEnds.require("RevoluteJoint", a, b);
        return new RevoluteJoint(
                a, b, JointEnds.frame(a, x, y, 0), JointEnds.frame(b, x, y, 0), JointSettings.NONE);
    }

    @Override
    public RevoluteJoint with(JointSettings other) {
        return new RevoluteJoint(a, b, frameA, frameB, other);
    }

    @Override
    public JointKind kind() {
        return JointKind.REVOLUTE;
    }
}
