package tools.jackson.databind.exc;

/** A value is not of the kind that was asked for. */
public final class JsonNodeException extends RuntimeException {

    public JsonNodeException(String message) {
        super(message);
    }
}
