package rigibo.frontend.scene;

/** The keys that scenes listen to; Esc and F11 are the window's own. */
public enum Key {
    ENTER,
    SPACE,
    TAB,
    BACKSPACE,
    PERIOD,
    LEFT_BRACKET,
    RIGHT_BRACKET,
    HOME,
    UP,
    DOWN,
    LEFT,
    RIGHT,
    F1,
    B,
    D,
    E,
    G,
    H,
    L,
    M,
    N,
    P,
    R,
    S,
    DIGIT_1,
    DIGIT_2,
    DIGIT_3,
    DIGIT_4
}
