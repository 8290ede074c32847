package rigibo.frontend.puzzle.generate;

import java.util.ArrayList;
import java.util.List;

/**
 * A column of high and low boxes in a shaft, with the ball on top. The ball comes out through a
 * window when the deleted boxes are together as high as the window is deep.
 */
final class TowerStart implements Start {

    private static final double WALL = 0.3;
    private static final double SHAFT = 0.8;
    private static final double BOX = 0.72;
    private static final double HIGH = 0.6;
    private static final double LOW = 0.3;

    /** The wedge between column and ball: its height at the left and right edge, m. */
    private static final double WEDGE_LEFT = 0.55;

    private static final double WEDGE_RIGHT = 0.2;

    /** Height of the wedge's right edge above the sill when the ball comes out, m. */
    private static final double STEP = 0.07;

    /** Length of the sill from the shaft on which the ball starts rolling, m. */
    private static final double SILL = 0.3;

    @Override
    public Spot build(Plan plan, Chance chance, double left, double y) {
        List<Double> heights = shuffled(chance, heights(chance));
        List<Double> needed =
                chance.oneOf(
                        List.of(List.of(HIGH, HIGH), List.of(HIGH, LOW), List.of(HIGH, HIGH, LOW)));
        double depth = sum(needed);
        double base = y + STEP - WEDGE_RIGHT - (sum(heights) - depth);
        Spot foot = new Spot(left + WALL, base);
        column(plan, foot, heights, new ArrayList<>(needed));
        shaft(plan, foot, y, depth);
        ball(plan, foot.plus(SHAFT / 2, sum(heights)));
        Spot sill = foot.plus(SHAFT, 0);
        return new Spot(sill.x() + SILL, y - 0.04);
    }

    private static List<Double> heights(Chance chance) {
        List<Double> heights = new ArrayList<>(List.of(HIGH, HIGH, LOW));
        for (int more = 1 + chance.below(2); more > 0; more--) {
            heights.add(chance.oneOf(List.of(HIGH, LOW)));
        }
        return heights;
    }

    private static List<Double> shuffled(Chance chance, List<Double> some) {
        List<Double> left = new ArrayList<>(some);
        List<Double> shuffled = new ArrayList<>();
        while (!left.isEmpty()) {
            shuffled.add(left.remove(chance.below(left.size())));
        }
        return shuffled;
    }

    private static double sum(List<Double> heights) {
        return heights.stream().mapToDouble(Double::doubleValue).sum();
    }

    /** Stacks the boxes; those to delete are the uppermost ones of each height needed. */
    private static void column(Plan plan, Spot foot, List<Double> heights, List<Double> needed) {
        double left = foot.x() + (SHAFT - BOX) / 2;
        double bottom = foot.y();
        List<String> ids = new ArrayList<>();
        for (double height : heights) {
            ids.add(plan.box("box", left, bottom, left + BOX, bottom + height));
            bottom += height;
        }
        for (int i = heights.size() - 1; i >= 0; i--) {
            if (needed.remove(heights.get(i))) {
                plan.releases(ids.get(i));
            }
        }
    }

    private static void shaft(Plan plan, Spot foot, double sill, double depth) {
        double right = foot.x() + SHAFT;
        double lintel = sill + 2 * plan.radius() + 0.27;
        double top = Math.max(lintel + 0.3, sill + depth + 2 * plan.radius() + 0.3);
        plan.stone(foot.x() - WALL, foot.y() - Plan.SLAB, foot.x(), top);
        plan.stone(foot.x(), foot.y() - Plan.SLAB, right, foot.y());
        plan.stone(right, lintel, right + WALL, top);
        plan.stone(right, foot.y() - Plan.SLAB, right + SILL, sill - Plan.SLAB);
        plan.slope(new Spot(right, sill), new Spot(right + SILL, sill - 0.04));
    }

    private static void ball(Plan plan, Spot top) {
        double half = BOX / 2;
        plan.wedge(top, -half, 0, half, 0, half, WEDGE_RIGHT, -half, WEDGE_LEFT);
        double slope = (WEDGE_LEFT - WEDGE_RIGHT) / BOX;
        double x = SHAFT / 2 - plan.radius();
        double surface = WEDGE_RIGHT + slope * (half - x);
        plan.ball(top.x() + x, top.y() + surface + plan.radius() * Math.sqrt(1 + slope * slope));
    }
}
