package rigibo.fuzz.file;

/**
 * A valid file.
 *
 * @param name what the game calls it
 * @param bytes what is in it
 */
public record Sample(String name, byte[] bytes) {}
