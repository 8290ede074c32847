package rigibo.frontend.puzzle.generate;

/** A gap closed by a box that can be deleted and must stay. */
final class KeepWay implements Way {

    private final Gap gap;

    KeepWay(double radius) {
        gap = Gap.of(radius);
    }

    @Override
    public double length() {
        return gap.width();
    }

    @Override
    public Spot build(Plan plan, Spot from) {
        double seat = gap.seat(from);
        plan.box("bridge", gap.blockLeft(from), seat, gap.blockRight(from), seat + Gap.BLOCK);
        return gap.build(plan, from);
    }
}
