/**
 * The threads that share the work of a step, and the pictures that other threads read meanwhile.
 */
package rigibo.backend.team;
