package rigibo.frontend.puzzle.generate;

/** A basin under a sloping lid, over which the ball rolls out of the world. */
final class LidGoal implements Goal {

    private static final double THICKNESS = 0.15;

    /** Distance by which the lid's ends extend beyond the walls' inner corners, m. */
    private static final double BEYOND = 0.18;

    private final Basin basin;
    private final double fall;

    LidGoal(Chance chance) {
        basin = new Basin(chance);
        fall = chance.between(0.16, 0.28);
    }

    @Override
    public double length() {
        return basin.length();
    }

    @Override
    public void build(Plan plan, Spot from) {
        double leftTop = from.y() - THICKNESS - 0.08;
        double rightTop = leftTop - fall;
        basin.build(plan, from, leftTop, rightTop);
        Spot left = basin.leftCorner(from, leftTop);
        Spot right = basin.rightCorner(from, rightTop);
        // The lid lies on the left wall's inner corner, and with its own lower corner on the right
        // wall.
        Spot rightEnd = right.plus(BEYOND, 0);
        double slope = (rightEnd.y() - left.y()) / (rightEnd.x() - left.x());
        Spot leftEnd = left.plus(-BEYOND, -BEYOND * slope);
        plan.prepares(plan.board("lid", leftEnd, rightEnd, THICKNESS));
    }
}
