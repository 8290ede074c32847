package rigibo.backend.setup;

/** The kinds of joints, each of which has a definition of its own. */
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
