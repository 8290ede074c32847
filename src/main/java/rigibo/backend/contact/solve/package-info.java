/**
 * Finds the impulses that keep the rows of an island: by passes, or by elimination of all that
 * carry load. It sees the packed island alone.
 */
package rigibo.backend.contact.solve;
