package rigibo.frontend.puzzle.generate;

/**
 * A gap in the path, a little wider than the ball, with a seat for a block that closes it.
 *
 * @param width of the seat, m
 */
record Gap(double width) {

    /** Length of each of the two lips on which a block comes to lie, m. */
    private static final double LIP = 0.13;

    /** Clearance of the ball between the lips, m. */
    private static final double FREE = 0.08;

    /** Clearance of the block in its seat, m: it may fall two centimetres aside. */
    private static final double PLAY = 0.03;

    /**
     * Depth of the block's surface below the path before it, and of the path after it below that.
     */
    private static final double STEP = 0.02;

    static final double BLOCK = Plan.SLAB;

    /** The gap for a ball of a radius, m. */
    static Gap of(double radius) {
        return new Gap(2 * radius + FREE + 2 * LIP);
    }

    /** Builds the lips; returns the spot where the path goes on. */
    Spot build(Plan plan, Spot from) {
        double top = from.y() - STEP - BLOCK;
        double right = from.x() + width;
        plan.stone(from.x() - LIP, top - LIP, from.x() + LIP, top);
        plan.stone(right - LIP, top - LIP, right + LIP, top);
        return from.plus(width, -2 * STEP);
    }

    double blockLeft(Spot from) {
        return from.x() + PLAY;
    }

    double blockRight(Spot from) {
        return from.x() + width - PLAY;
    }

    /** Height of the lower surface of a block in its seat, m. */
    double seat(Spot from) {
        return from.y() - STEP - BLOCK;
    }
}
