package rigibo.fuzz.file;

/**
 * A file that breaks the game.
 *
 * @param kind of the file
 * @param file its name and content
 * @param words the failure
 */
public record FileFailure(String kind, Sample file, String words) {}
