package rigibo.frontend.puzzle.generate;

import rigibo.frontend.puzzle.level.Substance;

import java.util.ArrayList;
import java.util.List;

/** Draws the plan of a level: one path to the right, or one to the right and one back below it. */
final class Architect {

    static final List<Start> STARTS =
            List.of(
                    new TiltStart(),
                    new WeightStart(),
                    new DoorStart(),
                    new TrapStart(),
                    new TowerStart());

    private static final List<Substance> GROUNDS =
            List.of(Substance.STONE, Substance.STONE, Substance.IRON);

    /** Room at the sides of the world, m. */
    private static final double EDGE = 0.35;

    /** Fall of the path for each metre, m. */
    private static final double LEAST_SLOPE = 0.08;

    private static final double MOST_SLOPE = 0.14;

    /** Shortest plain part of the path before and after a piece, m. */
    private static final double PLAIN = 0.45;

    /** The value drawn for a goal with a lid. */
    private static final int LIDDED = 3;

    private final Chance chance;
    private final Plan plan;

    private Architect(Chance chance) {
        this.chance = chance;
        plan = new Plan(chance.between(0.28, 0.33), chance.oneOf(GROUNDS));
    }

    static Plan plan(Chance chance) {
        Architect architect = new Architect(chance);
        if (chance.happens(50)) {
            architect.plan.turn();
        }
        if (chance.happens(35)) {
            architect.oneWay();
        } else {
            architect.thereAndBack();
        }
        return architect.plan;
    }

    private void oneWay() {
        Spot from = start().build(plan, chance, EDGE, chance.between(5, 6.5));
        List<Way> ways = chance.happens(80) ? List.of(crossing()) : List.of();
        Goal goal = goal(ways);
        goal.build(plan, lay(from, Plan.WIDTH - EDGE - goal.length(), ways));
    }

    private void thereAndBack() {
        Spot from = start().build(plan, chance, EDGE, chance.between(6.8, 7.4));
        List<Way> ways = chance.happens(40) ? List.of(new DoorWay(chance)) : List.of();
        double turning = 2 * plan.radius() + 0.4;
        Spot end = lay(from, Plan.WIDTH - EDGE - turning, ways);
        plan.turn();
        double y = end.y() - chance.between(1.9, 2.4);
        plan.stone(EDGE - 0.2, y - Plan.SLAB, EDGE, end.y() + 1);
        List<Way> crossings = crossings();
        Goal goal = goal(crossings);
        Spot begin = new Spot(EDGE, y);
        goal.build(plan, lay(begin, Plan.WIDTH - EDGE - goal.length(), crossings));
    }

    private Start start() {
        return chance.oneOf(STARTS);
    }

    /** A goal at the end of a path: with a lid, unless the path has a trap of its own. */
    private Goal goal(List<Way> ways) {
        boolean isTrapped = ways.stream().anyMatch(BridgeWay.class::isInstance);
        return switch (isTrapped ? chance.below(5) : LIDDED) {
            case 0 -> new Basin(chance);
            case 1, 2 -> new StopGoal(chance);
            default -> new LidGoal(chance);
        };
    }

    private Way crossing() {
        return switch (chance.below(5)) {
            case 0 -> new DoorWay(chance);
            case 1, 2 -> new KeepWay(plan.radius());
            default -> new BridgeWay(chance, plan.radius());
        };
    }

    private List<Way> crossings() {
        List<Way> ways = new ArrayList<>();
        ways.add(crossing());
        if (chance.happens(40)) {
            ways.add(crossing());
        }
        return ways;
    }

    /** Lays a sloping path up to an x, with pieces on it at even distances; returns its end. */
    private Spot lay(Spot from, double right, List<Way> pieces) {
        double slope = chance.between(LEAST_SLOPE, MOST_SLOPE);
        double taken = pieces.stream().mapToDouble(Way::length).sum();
        double plain = (right - from.x() - taken) / (pieces.size() + 1);
        if (plain < PLAIN) {
            return pieces.isEmpty() ? from : lay(from, right, pieces.subList(1, pieces.size()));
        }
        Spot at = sloping(from.plus(0, -0.02), plain, slope);
        for (Way piece : pieces) {
            at = sloping(piece.build(plan, at), plain, slope);
        }
        return at;
    }

    private Spot sloping(Spot from, double length, double slope) {
        Spot to = from.plus(length, -length * slope);
        plan.slope(from, to);
        return to;
    }
}
