package rigibo.backend;

/**
 * A joint that broke in the last step: its mean load was over what it bears, impacts included.
 *
 * <pre>{@code
 * pool.step(1 / 60.0);
 * for (JointBreak broken : pool.brokenJoints()) {
 *     System.out.println(broken.definition().kind() + " gave way at " + broken.force() + " N");
 * }
 * }</pre>
 *
 * @param joint is no longer in its pool
 * @param definition as it was
 * @param force N, on B
 * @param torque N·m, on B about its anchor
 */
public record JointBreak(Joint joint, JointDefinition definition, double force, double torque) {}
