/** The threads that share the work of a step. */
package rigibo.backend.team;
