package rigibo.frontend.puzzle.rules;

/** The result of a click; no click is lost silently. */
public enum ClickResult {
    DELETED,
    /** A deletable body was meant, but the cooldown still runs. */
    COOLING_DOWN,
    /** The body under the pointer cannot be deleted. */
    NOT_DELETABLE,
    /** The level's clicks are used up. */
    NO_CLICKS_LEFT,
    /** There is no body. */
    NOTHING_THERE,
    /** The game is won or lost. */
    OVER
}
