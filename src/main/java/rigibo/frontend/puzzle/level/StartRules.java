package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Fault;

/** E121 a ball starts outside the world. */
final class StartRules {

    private StartRules() {}

    static void check(LevelSketch sketch) {
        sketch.world()
                .ifPresent(
                        world ->
                                sketch.balls()
                                        .forEach(
                                                ball -> requireInside(sketch, ball, world.part())));
    }

    private static void requireInside(LevelSketch sketch, Located<Ball> at, World world) {
        Ball ball = at.part();
        boolean isInside =
                ball.x() >= ball.radius()
                        && ball.x() <= world.width() - ball.radius()
                        && ball.y() >= ball.radius()
                        && ball.y() <= world.height() - ball.radius();
        if (!isInside) {
            String words =
                    "E121 %s starts outside the world: at (%s, %s) with radius %s in %s × %s m";
            sketch.json()
                    .error(
                            at.pointer(),
                            () ->
                                    Fault.of(
                                            "E121",
                                            words,
                                            ball.name(),
                                            ball.x(),
                                            ball.y(),
                                            ball.radius(),
                                            world.width(),
                                            world.height()));
        }
    }
}
