/**
 * Two shapes at two poses: manifolds, distance, queries, and the time of impact of moving shapes.
 * Metres, seconds and radians; A and B always come in that order, and normals point from A to B.
 * Knows only shapes, except for the narrow phase, which visits stored pairs.
 */
package rigibo.backend.collision;
