/**
 * Rest: islands of bodies that lean on each other, their sleep, and who wakes whom. Knows contacts
 * as storage keeps them, not how they are solved.
 */
package rigibo.backend.rest;
