/**
 * The narrow phase: visits stored pairs, and decides which points of their manifolds count where
 * parts, chains or fixed bodies meet in seams. Metres, seconds and radians; A and B always come in
 * that order, and normals point from A to B.
 */
package rigibo.backend.collision;
