package rigibo.backend.setup;

/**
 * The kinds of joints; each has its own {@code JointDefinition}.
 *
 * <pre>{@code
 * for (Joint joint : pool.joints()) {
 *     if (joint.kind() == JointKind.REVOLUTE) {
 *         System.out.println(joint.angle());
 *     }
 * }
 * }</pre>
 */
public enum JointKind {
    REVOLUTE,
    PRISMATIC,
    DISTANCE,
    WELD,
    WHEEL,
    MOTOR,
    MOUSE,
    GEAR,
    PULLEY,
    FILTER
}
