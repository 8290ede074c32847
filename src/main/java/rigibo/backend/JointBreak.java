package rigibo.backend;

/**
 * A joint that broke in the last step because its mean load over the step, impacts included, was
 * over its breaking load.
 *
 * <pre>{@code
 * pool.step(1 / 60.0);
 * for (JointBreak broken : pool.brokenJoints()) {
 *     System.out.println(broken.definition().kind() + " gave way at " + broken.force() + " N");
 * }
 * }</pre>
 *
 * @param joint the joint, which is no longer in its pool
 * @param definition the joint's definition before it broke
 * @param force magnitude of the mean force on B over the step, N
 * @param torque mean torque on B about its anchor over the step, N·m, counter-clockwise
 */
public record JointBreak(Joint joint, JointDefinition definition, double force, double torque) {}
