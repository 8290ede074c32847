package rigibo.frontend.puzzle.generate;

import rigibo.frontend.puzzle.level.Substance;

import java.util.List;

/** A gap above which a heavy block lies on a beam: without the beam it falls and closes the gap. */
final class BridgeWay implements Way {

    private static final double BRACKET = 0.3;
    private static final double BEAM = 0.18;

    private final Gap gap;
    private final double clearance;
    private final Substance made;

    BridgeWay(Chance chance, double radius) {
        gap = Gap.of(radius);
        clearance = 2 * radius + chance.between(0.2, 0.5);
        made = chance.oneOf(List.of(Substance.IRON, Substance.STONE, Substance.ICE));
    }

    @Override
    public double length() {
        return gap.width();
    }

    @Override
    public Spot build(Plan plan, Spot from) {
        double right = from.x() + gap.width();
        double bottom = from.y() + clearance;
        double top = bottom + BRACKET;
        plan.stone(from.x() - BRACKET, bottom, from.x(), top);
        plan.stone(right, bottom, right + BRACKET, top);
        double over = 0.7 * BRACKET;
        plan.prepares(plan.box("beam", from.x() - over, top, right + over, top + BEAM));
        double block = top + BEAM;
        plan.load(made, gap.blockLeft(from), block, gap.blockRight(from), block + Gap.BLOCK);
        return gap.build(plan, from);
    }
}
