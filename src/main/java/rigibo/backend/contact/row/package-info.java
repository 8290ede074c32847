/**
 * The state of one island: its bodies ({@code Motions}) and its contacts ({@code PackedContacts}).
 *
 * <p>Its writers: {@code RowBuilder} packs an island from the pool's columns; {@code FreshRows},
 * {@code TurningRows}, {@code CurvedRows} and {@code RunningRows} write rows again that change
 * along the step; {@code Kick} and the solvers write velocities; {@code Motions} itself and the
 * removal of overlap write places; the solvers write impulses; and {@code IslandResults} writes all
 * of it back into the pool's columns.
 */
package rigibo.backend.contact.row;
