package rigibo.frontend.puzzle.level;

/**
 * A body or joint of a level on which a click acts.
 *
 * @param id unique in its level
 * @param verb what the click does
 */
public record Clickable(String id, Verb verb) {}
