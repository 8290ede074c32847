package tools.jackson.core;

/** Thrown when a text is not JSON. */
public class JacksonException extends RuntimeException {

    private final transient TokenStreamLocation location;

    protected JacksonException(String message, TokenStreamLocation location) {
        super(message);
        this.location = location;
    }

    public TokenStreamLocation getLocation() {
        return location;
    }

    public String getOriginalMessage() {
        return getMessage();
    }
}
