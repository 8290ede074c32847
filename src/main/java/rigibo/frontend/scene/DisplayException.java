package rigibo.frontend.scene;

/** Something about the window that the player should read: a sentence, not a stack trace. */
public final class DisplayException extends RuntimeException {

    private static final long serialVersionUID = 1;

    /** The sentence. */
    public DisplayException(String message) {
        super(message);
    }
}
