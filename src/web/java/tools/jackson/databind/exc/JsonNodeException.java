package tools.jackson.databind.exc;

/** Thrown when a value is not of the kind asked for. */
public final class JsonNodeException extends RuntimeException {

    public JsonNodeException(String message) {
        super(message);
    }
}
