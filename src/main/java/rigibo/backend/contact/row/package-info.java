/**
 * The state of one island: its bodies ({@code Motions}) and its contacts ({@code PackedContacts}).
 *
 * <p>Who writes what of it: {@code RowBuilder} packs an island from the pool's columns, {@code
 * FreshRows}, {@code TurningRows}, {@code CurvedRows} and {@code RunningRows} write its rows anew
 * where they change along the step, {@code Kick} and solvers write velocities, {@code Motions}
 * itself and the recovery from overlap write places, solvers write impulses, and {@code
 * IslandResults} takes all of it back into the pool's columns.
 */
package rigibo.backend.contact.row;
