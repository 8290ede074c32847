/**
 * Scenes in which much moves, timed beside other engines step by step, and what became of them
 * while they moved: speed that is bought by passing through each other is seen.
 */
package rigibo.lab.bench.moving;
