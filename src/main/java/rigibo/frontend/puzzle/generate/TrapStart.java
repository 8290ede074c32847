package rigibo.frontend.puzzle.generate;

/** A ball on one or two floors above a slope, each a board that can be deleted. */
final class TrapStart implements Start {

    private static final double WALL = 0.25;
    private static final double SLOPE = 0.14;
    private static final double BRACKET = 0.3;
    private static final double BOARD = 0.15;

    /** Overlap of a board with each bracket, m. */
    private static final double OVERLAP = 0.2;

    /** Distance between two floors, m. */
    private static final double STOREY = 0.6;

    @Override
    public Spot build(Plan plan, Chance chance, double left, double y) {
        double width = chance.between(1, 1.5);
        double begin = left + WALL + BRACKET;
        double end = begin + width;
        Spot foot = new Spot(end + BRACKET + chance.between(0.1, 0.3), y);
        Spot top = new Spot(left + WALL, y + SLOPE * (foot.x() - left - WALL));
        plan.slope(top, foot);
        double bottom = top.y() + 2 * plan.radius() + 0.15;
        int floors = 1 + chance.below(2);
        double upper = bottom;
        for (int floor = 0; floor < floors; floor++) {
            upper = bottom + floor * STOREY + BRACKET;
            plan.stone(left + WALL, upper - BRACKET, begin, upper);
            plan.stone(end, upper - BRACKET, end + BRACKET, upper);
            double over = OVERLAP;
            plan.releases(plan.box("floor", begin - over, upper, end + over, upper + BOARD));
        }
        plan.stone(left, y - Plan.SLAB, left + WALL, upper + 1);
        plan.ball((begin + end) / 2, upper + BOARD + plan.radius());
        return foot;
    }
}
