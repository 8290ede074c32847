package rigibo.frontend.puzzle.generate;

/**
 * A point on the surface along which the ball rolls, in the plan's frame, in which the ball rolls
 * to the right.
 *
 * @param x m
 * @param y m, up
 */
record Spot(double x, double y) {

    Spot plus(double right, double up) {
        return new Spot(x + right, y + up);
    }
}
