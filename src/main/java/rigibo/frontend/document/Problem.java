package rigibo.frontend.document;

/**
 * A problem of a file.
 *
 * @param severity whether the file may still be used
 * @param file the file as the user named it
 * @param place where in the file
 * @param pointer JSON pointer of the value at fault; empty for the whole file
 * @param fault what is wrong
 * @param cause of it, for players
 */
public record Problem(
        Severity severity, String file, Place place, String pointer, Fault fault, Cause cause) {

    /** Whether a file with this problem may be used. */
    public enum Severity {
        /** It may not. */
        ERROR,
        /** It may. */
        WARNING
    }

    /** A problem of what a file contains. */
    public Problem(Severity severity, String file, Place place, String pointer, Fault fault) {
        this(severity, file, place, pointer, fault, Cause.CONTENT);
    }

    /** An error of a file as a whole. */
    public static Problem ofWhole(String file, Cause cause, Fault fault) {
        return new Problem(Severity.ERROR, file, Place.START, "", fault, cause);
    }

    /** The exact message: what is wrong and what was expected. */
    public String message() {
        return Escape.controls(fault.message());
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
        return where() + ": " + (isError() ? "" : "warning: ") + message();
    }

    /** Where in which file, as {@link #toString()} begins. */
    public String where() {
        boolean isOfWhole = place.equals(Place.START) && pointer.isEmpty();
        return Escape.controls(file)
                + (isOfWhole ? "" : ":" + place)
                + (pointer.isEmpty() ? "" : ": " + Escape.controls(pointer));
    }
}
