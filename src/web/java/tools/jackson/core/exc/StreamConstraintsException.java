package tools.jackson.core.exc;

import tools.jackson.core.JacksonException;
import tools.jackson.core.TokenStreamLocation;

/** A text goes beyond what is read. */
public final class StreamConstraintsException extends JacksonException {

    public StreamConstraintsException(String message, TokenStreamLocation location) {
        super(message, location);
    }
}
