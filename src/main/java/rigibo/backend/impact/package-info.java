/**
 * The impact law: what impulses an impact between two bodies exchanges at one instant, with one or
 * two points of contact, elasticity and friction. Used by bodies in flight and inside piles.
 */
package rigibo.backend.impact;
