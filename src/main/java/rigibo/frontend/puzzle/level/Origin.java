package rigibo.frontend.puzzle.level;

/**
 * The seed and generator of a level made by chance; the same origin gives the same level
 * everywhere.
 *
 * @param seed that decides the level
 * @param generator version of the generator; another version makes another level of the seed
 */
public record Origin(long seed, int generator) {}
