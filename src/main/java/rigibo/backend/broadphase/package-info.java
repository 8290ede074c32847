/**
 * Size fixtures: an axis-aligned box round every body, kept in a tree. Only bodies within each
 * other's fixtures are looked at further, for speed and memory.
 */
package rigibo.backend.broadphase;
