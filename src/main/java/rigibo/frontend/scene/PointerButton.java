package rigibo.frontend.scene;

/** A button of a mouse. */
public enum PointerButton {
    LEFT,
    RIGHT,
    MIDDLE
}
