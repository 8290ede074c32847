package rigibo.frontend.puzzle.level;

/**
 * Something wrong with a level file.
 *
 * @param severity whether the level may still be played
 * @param file the file as the user named it
 * @param place where in the file
 * @param pointer JSON pointer of the value at fault; empty for the whole file
 * @param message what is wrong and what was expected
 */
public record Problem(Severity severity, String file, Place place, String pointer, String message) {

    /** Whether a level with this problem may be played. */
    public enum Severity {
        /** It may not. */
        ERROR,
        /** It may. */
        WARNING
    }

    public boolean isError() {
        return severity == Severity.ERROR;
    }

    /** {@code file:line:column: /pointer: message}, as editors and compilers write it. */
    @Override
    public String toString() {
        return file
                + ":"
                + place
                + ": "
                + (pointer.isEmpty() ? "" : pointer + ": ")
                + (isError() ? "" : "warning: ")
                + message;
    }
}
