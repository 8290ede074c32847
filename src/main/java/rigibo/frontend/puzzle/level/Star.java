package rigibo.frontend.puzzle.level;

/**
 * The secret star of a level. It does not affect the level's hash, so that runs kept before a level
 * had a star can still be played.
 *
 * @param text states the feat to players who have found the star
 * @param feat that earns it, besides solving the level
 * @param solution clicks known to earn it
 */
public record Star(Wording text, Feat feat, Solution solution) {}
