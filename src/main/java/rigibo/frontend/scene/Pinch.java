package rigibo.frontend.scene;

/**
 * How two fingers moved since the last report: the move of their middle, and the growth of their
 * distance.
 *
 * @param factor by which the distance between them grew, greater than 0
 * @param x where their middle is now, px
 * @param y where their middle is now, px
 * @param dx how far it moved, px
 * @param dy how far it moved, px
 */
public record Pinch(double factor, double x, double y, double dx, double dy) {}
