package rigibo.frontend.puzzle.generate;

/** The beginning of the path: holds the ball until clicks release it to the right. */
interface Start {

    /**
     * Builds it, the ball included.
     *
     * @param left its left edge, m
     * @param y height at which the ball comes out, m
     * @return the spot where the ball comes out
     */
    Spot build(Plan plan, Chance chance, double left, double y);
}
