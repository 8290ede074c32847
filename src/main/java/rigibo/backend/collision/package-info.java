/**
 * Two shapes at two poses: manifolds, distance, queries, and the time at which moving shapes meet.
 * Metres, seconds and radians; A and B are always in that order and normals point from A to B.
 * Knows shapes alone, except for the stage that walks over stored pairs.
 */
package rigibo.backend.collision;
