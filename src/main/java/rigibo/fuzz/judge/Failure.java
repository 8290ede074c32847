package rigibo.fuzz.judge;

/**
 * A law that a program broke.
 *
 * @param law which law
 * @param operation after how many operations, counted from 0
 * @param words what was seen
 */
public record Failure(String law, int operation, String words) {}
