/** The threads that share the work of a step, and what threads that ask meanwhile are given. */
package rigibo.backend.team;
