package rigibo.frontend.puzzle.rules;

/** The result of a click; no click is lost silently. */
public enum ClickResult {
    /** It did what the level says. */
    DONE,
    /** Something clickable was meant, but the cooldown still runs. */
    COOLING_DOWN,
    /** The body under the pointer stays as it is. */
    NOT_CLICKABLE,
    /** The level's clicks are used up. */
    NO_CLICKS_LEFT,
    /** There is no body. */
    NOTHING_THERE,
    /** The game is won or lost. */
    OVER
}
