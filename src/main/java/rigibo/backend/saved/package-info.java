/**
 * A pool's state outside of it: snapshots as bytes and back, and the hash of the state. Knows
 * columns only as their table shows them, so that a column that is added there is saved and hashed;
 * no stage of a step knows this room. All numbers are SI.
 */
package rigibo.backend.saved;
