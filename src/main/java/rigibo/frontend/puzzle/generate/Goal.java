package rigibo.frontend.puzzle.generate;

/** Where the way ends: the platform and what is around it. */
interface Goal {

    /** Its length along x, m. */
    double length();

    /** Builds it on from a spot. */
    void build(Plan plan, Spot from);
}
