package rigibo.frontend.puzzle.level;

/**
 * A part of a level and where its file states it.
 *
 * @param pointer JSON pointer of the part
 * @param part the part itself
 */
record Located<T>(String pointer, T part) {}
