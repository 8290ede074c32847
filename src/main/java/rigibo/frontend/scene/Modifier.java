package rigibo.frontend.scene;

/** A key that gives others another meaning while it is held. */
public enum Modifier {
    SHIFT,
    /** Ctrl; the command key where that is the custom. */
    CONTROL
}
