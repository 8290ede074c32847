package rigibo.frontend.puzzle.generate;

/** A piece of the ball's way. */
interface Way {

    /** Its length along x, m. */
    double length();

    /** Builds it on from a spot; returns where the ball goes on. */
    Spot build(Plan plan, Spot from);
}
