/**
 * Solved runs as files: their recording, reading, and the test that they replay to the same bits.
 * Time counts in steps of 1/60 s. Knows levels and the rules, no drawing and no window.
 */
package rigibo.frontend.puzzle.replay;
