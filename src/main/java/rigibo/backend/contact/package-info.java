/**
 * Bodies that rest, slide and roll on each other, solved island by island in substeps.
 *
 * <ul>
 *   <li>{@code row}: the packed state of one island: its bodies, and its contacts as solver rows;
 *   <li>{@code solve}: passes over contacts, elimination of rows, removal of overlap, and limits on
 *       energy;
 *   <li>{@code bounce}: impacts between bodies that also touch others;
 *   <li>{@code joint}: islands with joints;
 *   <li>{@code hold}: whether an island is at rest.
 * </ul>
 *
 * <p>{@code IslandSolver} calls them in order. A small island that is calm, or for which
 * elimination is cheap, is solved whole: all rows that carry load are eliminated at once. Other
 * islands are solved in passes, contact by contact. Overlap is removed by moving bodies.
 *
 * <p>A step of n substeps of length h is a leapfrog: velocities are those at the middle of a
 * substep, so the first and the last kick have half the length. A body that loses its support thus
 * follows its exact parabola, and a steadily sliding one stops after exactly v²/(2μg).
 */
package rigibo.backend.contact;
