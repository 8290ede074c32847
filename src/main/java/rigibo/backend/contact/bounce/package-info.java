/** Impacts within an island: all of an instant at once where that has an answer, else in turn. */
package rigibo.backend.contact.bounce;
