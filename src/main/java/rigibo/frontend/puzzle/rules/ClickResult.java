package rigibo.frontend.puzzle.rules;

/** The result of a click; every click has one that the player sees. */
public enum ClickResult {
    /** The click acted as the level states. */
    DONE,
    /** A clickable target was hit, but the cooldown is still running. */
    COOLING_DOWN,
    /** The body under the pointer cannot be clicked. */
    NOT_CLICKABLE,
    /** The level's clicks are used up. */
    NO_CLICKS_LEFT,
    /** There is no body. */
    NOTHING_THERE,
    /** The game is won or lost. */
    OVER
}
