package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Require;

/**
 * Holds two bodies together as one piece. With a spring the angle between them can bend, as in a
 * fishing rod.
 *
 * <pre>{@code
 * pool.join(WeldJoint.at(crate, door, 0, 1).spring(4, 0.5)); // bends by 4 Hz
 * }</pre>
 *
 * @param a the first body
 * @param b the second body
 * @param frameA anchor and axis on A
 * @param frameB anchor and axis on B
 * @param settings the spring
 */
public record WeldJoint(
        RigidBody a, RigidBody b, JointFrame frameA, JointFrame frameB, JointSettings settings)
        implements JointDefinition {

    /**
     * Checks all parts.
     *
     * @throws IllegalArgumentException when one is missing or out of its range
     */
    public WeldJoint {
        JointEnds.require("WeldJoint", a, b);
        Require.present("WeldJoint.frameA", frameA);
        Require.present("WeldJoint.frameB", frameB);
        Require.present("WeldJoint.settings", settings)
                .requireOnly("WeldJoint", JointSettings.Part.SPRING);
    }

    /** A weld at a world point (m), which holds the bodies at their present relative pose. */
    public static WeldJoint at(RigidBody a, RigidBody b, double x, double y) {
        JointEnds.require("WeldJoint", a, b);
        return new WeldJoint(
                a, b, JointEnds.frame(a, x, y, 0), JointEnds.frame(b, x, y, 0), JointSettings.NONE);
    }

    @Override
    public WeldJoint with(JointSettings other) {
        return new WeldJoint(a, b, frameA, frameB, other);
    }

    @Override
    public JointKind kind() {
        return JointKind.WELD;
    }
}
