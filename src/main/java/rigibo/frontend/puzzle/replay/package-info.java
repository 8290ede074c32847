/**
 * Solved runs as files: what is recorded, how it is read again, and whether it replays to the same
 * bits. Time counts in steps of 1/60 s. Knows levels and the rules, no drawing and no window.
 */
package rigibo.frontend.puzzle.replay;
