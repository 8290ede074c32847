package rigibo.fuzz.judge;

/**
 * A law that a program broke.
 *
 * @param law which law
 * @param operation number of operations before it
 * @param words the failure
 */
public record Failure(String law, int operation, String words) {}
