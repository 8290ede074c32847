package rigibo.frontend.puzzle.generate;

/**
 * A point on the surface that the ball rolls along, in the frame of the plan: the ball goes to the
 * right.
 *
 * @param x m
 * @param y m, up
 */
record Spot(double x, double y) {

    Spot plus(double right, double up) {
        return new Spot(x + right, y + up);
    }
}
