package rigibo.frontend.puzzle.generate;

/** A board on two legs that tips to the side of the deleted leg, so that the ball rolls down. */
final class TiltStart implements Start {

    private static final double THICKNESS = 0.16;

    /** Distance from a leg's outer face to the end of the ledge on which the board lands, m. */
    private static final double INSET = 0.25;

    @Override
    public Spot build(Plan plan, Chance chance, double left, double y) {
        double right = left + chance.between(2.4, 3);
        plan.stone(left, y - Plan.SLAB, right, y);
        double leg = chance.between(0.3, 0.42);
        double top = y + chance.between(0.34, 0.5);
        plan.box("leg", left + INSET, y, left + INSET + leg, top);
        plan.releases(plan.box("leg", right - INSET - leg, y, right - INSET, top));
        double overhang = chance.between(0, 0.15);
        Spot from = new Spot(left + INSET - overhang, top);
        Spot to = new Spot(right - INSET + overhang, top);
        plan.board("board", from, to, THICKNESS);
        plan.ball((left + right) / 2, top + THICKNESS + plan.radius());
        return new Spot(right, y);
    }
}
