package rigibo.frontend.puzzle.level;

/**
 * The secret star of a level. It does not count for the level's hash, so that runs kept before a
 * level had one still play.
 *
 * @param text states the feat to whoever has found the star
 * @param feat what earns it, besides solving the level
 * @param solution clicks known to earn it
 */
public record Star(Wording text, Feat feat, Solution solution) {}
