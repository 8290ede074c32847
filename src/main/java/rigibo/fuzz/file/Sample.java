package rigibo.fuzz.file;

/**
 * A valid file.
 *
 * @param name its name in the game
 * @param bytes its content
 */
public record Sample(String name, byte[] bytes) {}
