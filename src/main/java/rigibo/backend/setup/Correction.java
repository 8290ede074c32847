package rigibo.backend.setup;

/** What is done about overlap. */
public enum Correction {
    /** Nothing: overlap stays as it is. */
    NONE,
    /** A strongly damped spring pushes apart, and its velocity is taken out again. */
    SOFT
}
