/**
 * How far two shapes are apart, whether they touch, what a ray or a cast shape meets, and when two
 * that move touch first. Metres, seconds and radians. Knows manifolds, no pairs.
 */
package rigibo.backend.collision.distance;
