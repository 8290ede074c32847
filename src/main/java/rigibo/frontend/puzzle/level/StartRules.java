package rigibo.frontend.puzzle.level;

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
            sketch.json()
                    .error(
                            at.pointer(),
                            () ->
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
