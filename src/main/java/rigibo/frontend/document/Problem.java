package rigibo.frontend.document;

/**
 * A problem of a file.
 *
 * @param severity whether the file may still be used
 * @param file the file as the user named it
 * @param place where in the file
 * @param pointer JSON pointer of the value at fault; empty for the whole file
 * @param message what is wrong and what was expected
 * @param cause of the message, for players
 */
public record Problem(
        Severity severity, String file, Place place, String pointer, String message, Cause cause) {

    /** Whether a file with this problem may be used. */
    public enum Severity {
        /** It may not. */
        ERROR,
        /** It may. */
        WARNING
    }

    public Problem {
        message = Escape.controls(message);
    }

    /** A problem of what a file contains. */
    public Problem(Severity severity, String file, Place place, String pointer, String message) {
        this(severity, file, place, pointer, message, Cause.CONTENT);
    }

    public boolean isError() {
        return severity == Severity.ERROR;
    }

    /**
     * {@code file:line:column: /pointer: message}, as editors and compilers write it; of a file as
     * a whole {@code file: message}.
     */
    @Override
    public String toString() {
        boolean isOfWhole = place.equals(Place.START) && pointer.isEmpty();
        return Escape.controls(file)
                + (isOfWhole ? "" : ":" + place)
                + ": "
                + (pointer.isEmpty() ? "" : Escape.controls(pointer) + ": ")
                + (isError() ? "" : "warning: ")
                + message;
    }
}
