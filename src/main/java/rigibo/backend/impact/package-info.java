/**
 * The impact law: the impulses of an impact between two bodies, with one or two points of contact,
 * elasticity and friction, and of several impacts at the same time. Used in flight and inside
 * piles.
 */
package rigibo.backend.impact;
