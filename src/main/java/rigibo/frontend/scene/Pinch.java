package rigibo.frontend.scene;

/**
 * What two fingers did since they were last heard of: they moved their middle, and drew apart.
 *
 * @param factor by which the distance between them grew, greater than 0
 * @param x where their middle is now, px
 * @param y where their middle is now, px
 * @param dx how far it moved, px
 * @param dy how far it moved, px
 */
public record Pinch(double factor, double x, double y, double dx, double dy) {}
