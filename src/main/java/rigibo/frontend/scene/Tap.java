package rigibo.frontend.scene;

/** When a finger presses what it touches. A mouse always presses at once. */
public enum Tap {
    /** As it comes down, and then it drags: sliders, and bodies that are flung. */
    AT_ONCE,
    /**
     * Not at all, unless the finger rests; then it presses the other button, since there is nothing
     * to drag.
     */
    RESTED,
    /** As it is lifted, unless it slid away or rested to look. */
    LIFTED,
    /** As it is lifted, wherever it slid: a choice among small things. */
    CHOSEN
}
