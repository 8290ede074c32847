package rigibo.frontend.puzzle.generate;

/** A platform open to the right, with a box at its end that must not be deleted. */
final class StopGoal implements Goal {

    private final double width;
    private final double depth;
    private final double stop;
    private final double height;

    StopGoal(Chance chance) {
        width = chance.between(1.8, 2.4);
        depth = chance.between(0.3, 0.6);
        stop = chance.between(0.4, 0.6);
        height = chance.between(0.6, 0.9);
    }

    @Override
    public double length() {
        return Basin.WALL + width;
    }

    @Override
    public void build(Plan plan, Spot from) {
        double floor = from.y() - depth;
        double left = from.x() + Basin.WALL;
        double right = left + width;
        plan.stone(from.x(), floor - 0.3, left, from.y() - 0.03);
        plan.platform((left + right) / 2, floor, width);
        plan.box("stop", right - stop, floor, right, floor + height);
    }
}
