/**
 * Piles: bodies that rest, slide and roll on each other, solved island by island with substeps.
 *
 * <p>A small island is solved whole: the rows that carry load are eliminated at once, and overlap
 * is taken back by moving bodies. A large one is passed over row by row, and pushes apart softly.
 *
 * <p>A step of n substeps of length h is a leapfrog: velocities live in the middle of the substeps,
 * so the first and the last kick are half as long. A body that loses its support in a pile still
 * falls along its exact parabola, and a steadily sliding one stops where the formula says.
 */
package rigibo.backend.contact;
