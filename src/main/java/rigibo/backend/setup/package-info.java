/**
 * The values a caller states: bodies, materials, joint settings and accuracy. Immutable, in SI
 * units, and checked when they are made. This package knows shapes, but no pool and no motion.
 */
package rigibo.backend.setup;
