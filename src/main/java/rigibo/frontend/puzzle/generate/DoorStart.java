package rigibo.frontend.puzzle.generate;

/** A slope on which the ball leans against a door. */
final class DoorStart implements Start {

    private static final double WALL = 0.25;
    private static final double SLOPE = 0.12;

    @Override
    public Spot build(Plan plan, Chance chance, double left, double y) {
        double length = chance.between(1.1, 1.9);
        Spot top = new Spot(left + WALL, y + SLOPE * length);
        Spot foot = new Spot(left + WALL + length, y);
        plan.stone(left, y - Plan.SLAB, left + WALL, top.y() + 2.5 * plan.radius());
        plan.slope(top, foot);
        Door door = new Door(chance);
        plan.releases(door.build(plan, foot));
        double x = foot.x() + Door.REBATE - plan.radius();
        double surface = y + SLOPE * (foot.x() - x);
        plan.ball(x, surface + plan.radius() * Math.sqrt(1 + SLOPE * SLOPE));
        return foot.plus(door.length(), 0);
    }
}
