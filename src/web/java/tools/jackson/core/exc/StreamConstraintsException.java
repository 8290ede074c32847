package tools.jackson.core.exc;

import tools.jackson.core.JacksonException;
import tools.jackson.core.TokenStreamLocation;

/** Thrown when a text is beyond the reader's bounds. */
public final class StreamConstraintsException extends JacksonException {

    public StreamConstraintsException(String message, TokenStreamLocation location) {
        super(message, location);
    }
}
