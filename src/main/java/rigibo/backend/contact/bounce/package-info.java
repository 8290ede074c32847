/** Impacts within an island: simultaneous ones together if that has a solution, else in turn. */
package rigibo.backend.contact.bounce;
