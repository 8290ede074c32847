package rigibo.frontend.puzzle.generate;

/** A platform between two walls. */
final class Basin implements Goal {

    static final double WALL = 0.25;

    private final double width;
    private final double depth;

    Basin(Chance chance) {
        width = chance.between(1.5, 2.1);
        depth = chance.between(0.9, 1.5);
    }

    @Override
    public double length() {
        return width + 2 * WALL;
    }

    @Override
    public void build(Plan plan, Spot from) {
        build(plan, from, from.y() - 0.03, from.y() + 1);
    }

    /** Builds it with walls up to two heights; returns the upper inner corners of the walls. */
    void build(Plan plan, Spot from, double leftTop, double rightTop) {
        double floor = from.y() - depth;
        double left = from.x() + WALL;
        double right = left + width;
        plan.stone(from.x(), floor - 0.3, left, leftTop);
        plan.stone(right, floor - 0.3, right + WALL, rightTop);
        plan.platform((left + right) / 2, floor, width);
    }

    /** The upper inner corner of the left wall, whose top is at {@code top}. */
    Spot leftCorner(Spot from, double top) {
        return new Spot(from.x() + WALL, top);
    }

    Spot rightCorner(Spot from, double top) {
        return new Spot(from.x() + WALL + width, top);
    }
}
