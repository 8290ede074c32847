package rigibo.frontend.puzzle.level;

/**
 * What a level was made from by chance; the same origin gives the same level everywhere.
 *
 * @param seed that decides the level
 * @param generator version of the generator, for another one makes another level of the seed
 */
public record Origin(long seed, int generator) {}
