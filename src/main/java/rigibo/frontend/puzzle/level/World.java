package rigibo.frontend.puzzle.level;

import rigibo.backend.effect.Effects;

/**
 * The space a level plays in, its origin at the bottom left, y up.
 *
 * @param width m
 * @param height m
 * @param effects what is simulated, gravity included
 */
public record World(double width, double height, Effects effects) {}
