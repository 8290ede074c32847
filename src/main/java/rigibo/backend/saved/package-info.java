/**
 * The state of a pool outside the pool: snapshots as bytes, and the hash of the state. Knows
 * columns only through their table, so that a new column is saved and hashed without a change here;
 * no stage of a step knows this room. All numbers are in SI units.
 */
package rigibo.backend.saved;
