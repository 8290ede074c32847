/**
 * The broad phase: an axis-aligned box round every shape, its fixture, kept in a tree, or in a grid
 * while it moves. Only shapes whose fixtures overlap are examined further, which saves time and
 * memory.
 */
package rigibo.backend.broadphase;
