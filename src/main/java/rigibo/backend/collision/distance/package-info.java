/**
 * Distances and overlaps of two shapes, rays, shape casts, and times of impact. Metres, seconds and
 * radians. Knows manifolds, no pairs.
 */
package rigibo.backend.collision.distance;
