package rigibo.frontend.puzzle.level;

import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** E120 two bodies overlap at the start; E121 the ball starts outside the world. */
final class StartRules {

    /** Overlap that counts as touching, m: what a rounded coordinate in a file may cost. */
    static final double TOUCHING = 1e-3;

    private static final double MILLIMETRES = 1000;

    private StartRules() {}

    static void check(LevelSketch sketch, Problems problems) {
        List<Located<BodyDefinition>> placed = placed(sketch);
        for (int i = 0; i < placed.size(); i++) {
            for (int j = 0; j < i; j++) {
                requireApart(placed.get(j), placed.get(i), problems);
            }
        }
        sketch.world()
                .ifPresent(
                        world ->
                                sketch.balls()
                                        .forEach(
                                                ball ->
                                                        requireInside(
                                                                ball, world.part(), problems)));
    }

    private static List<Located<BodyDefinition>> placed(LevelSketch sketch) {
        List<Located<BodyDefinition>> placed = new ArrayList<>();
        sketch.platform().ifPresent(p -> placed.add(located(p, p.part().definition())));
        sketch.balls().forEach(b -> placed.add(located(b, b.part().definition())));
        for (Located<LevelBody> body : sketch.bodies()) {
            placed.add(located(body, body.part().definition()));
        }
        return placed;
    }

    private static Located<BodyDefinition> located(Located<?> part, BodyDefinition definition) {
        return new Located<>(part.pointer(), part.place(), definition);
    }

    private static void requireApart(
            Located<BodyDefinition> first, Located<BodyDefinition> second, Problems problems) {
        BodyDefinition a = first.part();
        BodyDefinition b = second.part();
        if (a.type() == BodyType.STATIC && b.type() == BodyType.STATIC) {
            return; // Walls may be built of parts that overlap.
        }
        double depth = Overlap.depth(a, b);
        if (depth > TOUCHING) {
            String words = "E120 overlaps %s at the start by %.1f mm";
            problems.error(
                    second.place(),
                    second.pointer(),
                    String.format(Locale.ROOT, words, quoted(a.name()), depth * MILLIMETRES));
        }
    }

    private static String quoted(String name) {
        // An id has no blank, and every other name has one.
        return name.contains(" ") ? name : "\"" + name + "\"";
    }

    private static void requireInside(Located<Ball> at, World world, Problems problems) {
        Ball ball = at.part();
        boolean isInside =
                ball.x() >= ball.radius()
                        && ball.x() <= world.width() - ball.radius()
                        && ball.y() >= ball.radius()
                        && ball.y() <= world.height() - ball.radius();
        if (!isInside) {
            problems.error(
                    at.place(),
                    at.pointer(),
                    "E121 "
                            + ball.name()
                            + " starts outside the world: at ("
                            + ball.x()
                            + ", "
                            + ball.y()
                            + ") with radius "
                            + ball.radius()
                            + " in "
                            + world.width()
                            + " × "
                            + world.height()
                            + " m");
        }
    }
}
