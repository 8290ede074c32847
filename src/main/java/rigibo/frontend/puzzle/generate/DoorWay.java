package rigibo.frontend.puzzle.generate;

/** A door across the path, which holds the ball until it is deleted. */
final class DoorWay implements Way {

    private final Door door;

    DoorWay(Chance chance) {
        door = new Door(chance);
    }

    @Override
    public double length() {
        return door.length();
    }

    @Override
    public Spot build(Plan plan, Spot from) {
        plan.prepares(door.build(plan, from));
        return from.plus(door.length(), 0);
    }
}
