package rigibo.frontend.puzzle.level;

/**
 * A part of a level and its place in the file.
 *
 * @param pointer JSON pointer of the part
 * @param part the part itself
 */
record Located<T>(String pointer, T part) {}
