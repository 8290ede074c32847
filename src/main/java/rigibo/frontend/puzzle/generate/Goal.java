package rigibo.frontend.puzzle.generate;

/** The end of the path: the platform and its surroundings. */
interface Goal {

    /** Its length along x, m. */
    double length();

    /** Builds it from a spot on. */
    void build(Plan plan, Spot from);
}
