package rigibo.backend;

import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;

/**
 * Stops two bodies from colliding with each other; it restricts their motion in no other way.
 *
 * <pre>{@code
 * pool.join(new FilterJoint(crate, door)); // pass through each other
 * }</pre>
 *
 * @param a the first body
 * @param b the second body
 */
public record FilterJoint(RigidBody a, RigidBody b) implements JointDefinition {

    /**
     * Checks both bodies.
     *
     * @throws IllegalArgumentException when one is null, or both are the same body
     */
    public FilterJoint {
        JointEnds.require("FilterJoint", a, b);
    }

    @Override
    public JointSettings settings() {
        return JointSettings.NONE;
    }

    /**
     * This joint has no settings.
     *
     * @throws IllegalArgumentException when they are not {@link JointSettings#NONE}
     */
    @Override
    public FilterJoint with(JointSettings settings) {
        if (!settings.equals(JointSettings.NONE)) {
            throw new IllegalArgumentException("FilterJoint cannot have settings, was given");
        }
        return this;
    }

    @Override
    public JointKind kind() {
        return JointKind.FILTER;
    }
}
