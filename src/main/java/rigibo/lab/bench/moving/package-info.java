/**
 * Scenes in which much moves, timed step by step in our engine and in others. The scenes are
 * examined too, so that speed gained by letting bodies overlap is noticed.
 */
package rigibo.lab.bench.moving;
