package rigibo.backend;

/**
 * A joint that broke in the last step: its mean load was over what it bears, blows included.
 *
 * @param joint is no longer in its pool
 * @param definition as it was
 * @param force N, on B
 * @param torque N·m, on B about its anchor
 */
public record JointBreak(Joint joint, JointDefinition definition, double force, double torque) {}
