/**
 * The public face of the engine: a pool of rigid bodies in the plane. The engine uses no window,
 * file, clock or random number. SI units everywhere; y points up; angles are counter-clockwise.
 */
package rigibo.backend;
