/**
 * Makes levels by chance. A seed decides a plan, composed of a start that holds the ball, pieces of
 * its path, and a goal; the check's sieve keeps the plans that are puzzles. The same seed gives the
 * same level on every machine: all randomness comes from {@link
 * rigibo.frontend.puzzle.generate.Chance}, and effort is bounded by attempts, never by a clock.
 * Lengths in m, y up. Knows levels and their check; no window and no file.
 */
package rigibo.frontend.puzzle.generate;
