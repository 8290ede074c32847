package rigibo.backend;

import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;

/**
 * Two bodies that never meet, and are free otherwise.
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
     * Checks both.
     *
     * @throws IllegalArgumentException when one is missing, or both are one
     */
    public FilterJoint {
        JointEnds.require("FilterJoint", a, b);
    }

    @Override
    public JointSettings settings() {
        return JointSettings.NONE;
    }

    /**
     * It has none to set.
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
