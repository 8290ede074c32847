/**
 * Bodies that rest, slide and roll on each other, solved island by island in substeps.
 *
 * <ul>
 *   <li>{@code row}: the bodies and contacts of one island, packed, and what is written of them
 *       before they are solved;
 *   <li>{@code solve}: passes over contacts, elimination of rows, overlap, and the energy of both;
 *   <li>{@code bounce}: impacts between bodies that also touch others;
 *   <li>{@code hold}: whether what rests is held as it is.
 * </ul>
 *
 * <p>{@code IslandSolver} calls them in their order. A small island that is calm or narrow is
 * solved whole: the rows that carry load are eliminated at once. What moves, or is larger, is
 * passed over contact by contact. Overlap is taken back by moving bodies.
 *
 * <p>A step of n substeps of length h is a leapfrog: velocities live in the middle of the substeps,
 * so the first and the last kick are half as long. A body that loses its support still falls along
 * its exact parabola, and a steadily sliding one stops where the formula says.
 */
package rigibo.backend.contact;
