package rigibo.frontend.puzzle.generate;

/** A tall box in a frame that hangs over a level part of the path; no ball pushes it over. */
final class Door {

    /** Distance from the beginning of the level part to the door, m. */
    static final double REBATE = 0.02;

    /** Clearance in the frame, so that a door displaced by a centimetre still falls freely, m. */
    private static final double PLAY = 0.015;

    private static final double FRAME = 0.2;

    private final double width;
    private final double overlap;

    Door(Chance chance) {
        width = chance.between(0.28, 0.4);
        overlap = chance.between(0.4, 0.6);
    }

    double length() {
        return width + 2 * REBATE;
    }

    /** Builds it from a spot on; returns the door's id. */
    String build(Plan plan, Spot at) {
        plan.slope(at, at.plus(length(), 0));
        double left = at.x() + REBATE;
        double right = left + width;
        double lintel = at.y() + 2 * plan.radius() + 0.15;
        double top = lintel + overlap;
        plan.stone(left - PLAY - FRAME, lintel, left - PLAY, top);
        plan.stone(right + PLAY, lintel, right + PLAY + FRAME, top);
        return plan.box("door", left, at.y(), right, top);
    }
}
