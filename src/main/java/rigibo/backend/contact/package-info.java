/**
 * Piles: bodies that rest, slide and roll on each other, solved island by island with substeps.
 *
 * <p>A small island that is calm or narrow is solved whole: the rows that carry load are eliminated
 * at once. What moves, or is larger, is passed over contact by contact. Overlap is taken back by
 * moving bodies.
 *
 * <p>A step of n substeps of length h is a leapfrog: velocities live in the middle of the substeps,
 * so the first and the last kick are half as long. A body that loses its support in a pile still
 * falls along its exact parabola, and a steadily sliding one stops where the formula says.
 */
package rigibo.backend.contact;
