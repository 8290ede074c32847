/**
 * Where two shapes touch: points, gaps and a normal, for each pair of kinds. Metres and radians; A
 * and B always come in that order, and normals point from A to B. Knows only shapes, except that a
 * {@code Manifold} is written into stored pairs.
 */
package rigibo.backend.collision.manifold;
