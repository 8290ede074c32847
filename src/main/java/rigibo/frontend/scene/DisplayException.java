package rigibo.frontend.scene;

/** A failure of the window, worded for the player: a sentence, not a stack trace. */
public final class DisplayException extends RuntimeException {

    private static final long serialVersionUID = 1;

    /** The sentence. */
    public DisplayException(String message) {
        super(message);
    }
}
