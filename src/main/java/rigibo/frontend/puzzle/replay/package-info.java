/**
 * Solved runs as files: what is kept of one, how it is read again, and whether it plays back to the
 * same bits. Time counts in steps of 1/60 s. Knows levels and the rules, no drawing and no window.
 */
package rigibo.frontend.puzzle.replay;
