/**
 * Solves for the impulses of an island's rows: by passes, or by elimination of all rows that carry
 * load. This package sees only the packed island.
 */
package rigibo.backend.contact.solve;
