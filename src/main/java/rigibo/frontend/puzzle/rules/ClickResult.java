package rigibo.frontend.puzzle.rules;

/** What became of a click; none is silently lost. */
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
