package rigibo.frontend.puzzle.level;

import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.document.Document;
import rigibo.frontend.document.Fault;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;

/**
 * E120: two bodies overlap at the start. Sweeps from left to right, so that distant bodies are
 * never compared.
 */
final class ApartRules {

    /**
     * Overlap that counts as touching, m: the error that rounding a coordinate in a file may cause.
     */
    static final double TOUCHING = 1e-3;

    private static final double MILLIMETRES = 1000;

    private final Document json;

    /** Pairs of joined bodies, which never collide. */
    private final Set<String> joined;

    /** Bodies that the sweep has reached and not passed yet. */
    private final List<Placed> present = new ArrayList<>();

    /**
     * A body at its start.
     *
     * @param order in which problems name two of them
     * @param pointer of the body in the file
     * @param end name of the body in joints
     * @param print area that it covers
     */
    private record Placed(int order, String pointer, String end, Footprint print) {

        double left() {
            return print.bounds().minX;
        }

        double right() {
            return print.bounds().maxX;
        }
    }

    private ApartRules(LevelSketch sketch) {
        json = sketch.json();
        joined = JointRules.pairs(sketch.joints());
    }

    static void check(LevelSketch sketch) {
        ApartRules rules = new ApartRules(sketch);
        placed(sketch).stream()
                .sorted(Comparator.comparingDouble(Placed::left))
                .forEach(rules::reach);
    }

    private static List<Placed> placed(LevelSketch sketch) {
        List<Placed> placed = new ArrayList<>();
        sketch.platform()
                .ifPresent(
                        p -> add(placed, p.pointer(), LevelJoint.PLATFORM, p.part().definition()));
        for (int i = 0; i < sketch.balls().size(); i++) {
            Located<Ball> ball = sketch.balls().get(i);
            add(placed, ball.pointer(), LevelJoint.ball(i), ball.part().definition());
        }
        sketch.bodies()
                .forEach(b -> add(placed, b.pointer(), b.part().id(), b.part().definition()));
        return placed;
    }

    private static void add(List<Placed> placed, String pointer, String end, BodyDefinition body) {
        placed.add(new Placed(placed.size(), pointer, end, Footprint.of(body)));
    }

    private void reach(Placed next) {
        present.removeIf(passed -> passed.right() < next.left());
        for (Placed other : present) {
            if (other.order() < next.order()) {
                requireApart(other, next);
            } else {
                requireApart(next, other);
            }
        }
        present.add(next);
    }

    private void requireApart(Placed first, Placed second) {
        Footprint a = first.print();
        Footprint b = second.print();
        // Walls may be built of overlapping parts, lifts may start within them, and a body that
        // starts within a shelf passes it.
        boolean mayOverlap = a.isUnmoved() && b.isUnmoved() || a.isOneWay() || b.isOneWay();
        boolean areJoined = joined.contains(first.end() + " " + second.end());
        if (mayOverlap || areJoined || !a.bounds().overlaps(b.bounds())) {
            return;
        }
        double depth = Overlap.depth(a, b);
        if (depth > TOUCHING) {
            json.error(second.pointer(), () -> fault(first, depth));
        }
    }

    private static Fault fault(Placed other, double depth) {
        double millimetres = depth * MILLIMETRES;
        String name = quoted(other.print().body().name());
        return Fault.of("E120", "E120 overlaps %s at the start by %.1f mm", name, millimetres)
                .naming(LevelJoint.shown(other.end()), (int) Math.ceil(millimetres));
    }

    private static String quoted(String name) {
        // An id has no blank; every other name has one.
        return name.contains(" ") ? name : "\"" + name + "\"";
    }
}
