package rigibo.frontend.scene;

/** A key that changes the meaning of others while it is held. */
public enum Modifier {
    SHIFT,
    /** Ctrl; the command key where that is the custom. */
    CONTROL
}
