package rigibo.fuzz.file;

/**
 * A file that breaks the game.
 *
 * @param kind of the file
 * @param file what it is called, and what is in it
 * @param words what was seen
 */
public record FileFailure(String kind, Sample file, String words) {}
