package rigibo.frontend.puzzle.generate;

/** A piece of the ball's path. */
interface Way {

    /** Its length along x, m. */
    double length();

    /** Builds it from a spot on; returns the spot where the ball goes on. */
    Spot build(Plan plan, Spot from);
}
