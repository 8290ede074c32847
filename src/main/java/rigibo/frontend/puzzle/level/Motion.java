package rigibo.frontend.puzzle.level;

/**
 * The velocity of a body at the start.
 *
 * @param x m/s, to the right
 * @param y m/s, up
 * @param spin rad/s, counter-clockwise
 */
public record Motion(double x, double y, double spin) {}
