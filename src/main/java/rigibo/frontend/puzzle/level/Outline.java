package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Shape;

/**
 * A shape as a file states it. The engine keeps a polygon's corners relative to its centroid, a
 * file relative to whatever point its author chose; the offset between the two places the body.
 *
 * @param shape about its centroid
 * @param centroidX m, in the frame of the file's points
 * @param centroidY m, in the frame of the file's points
 */
record Outline(Shape shape, double centroidX, double centroidY) {}
