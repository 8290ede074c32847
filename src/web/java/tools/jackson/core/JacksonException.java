package tools.jackson.core;

/** A text is no JSON. */
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
