package rigibo.frontend.puzzle.generate;

import rigibo.frontend.puzzle.level.Substance;

import java.util.List;

/**
 * A heavy block on three feet with the ball on top. It tips when two feet on one side are gone,
 * towards that side.
 */
final class WeightStart implements Start {

    private static final double INSET = 0.3;

    @Override
    public Spot build(Plan plan, Chance chance, double left, double y) {
        double right = left + chance.between(2.4, 3);
        plan.stone(left, y - Plan.SLAB, right, y);
        double foot = chance.between(0.26, 0.36);
        double top = y + chance.between(0.28, 0.4);
        double middle = (left + right) / 2;
        plan.box("foot", left + INSET, y, left + INSET + foot, top);
        String second = plan.box("foot", middle - foot / 2, y, middle + foot / 2, top);
        plan.releases(plan.box("foot", right - INSET - foot, y, right - INSET, top));
        plan.releases(second);
        double height = chance.between(0.4, 0.7);
        Substance made = chance.oneOf(List.of(Substance.IRON, Substance.STONE));
        plan.load(made, left + INSET, top, right - INSET, top + height);
        plan.ball(middle, top + height + plan.radius());
        return new Spot(right, y);
    }
}
