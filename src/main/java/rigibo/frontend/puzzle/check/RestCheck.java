package rigibo.frontend.puzzle.check;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Length;
import rigibo.frontend.document.Fault;
import rigibo.frontend.puzzle.level.Ball;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/** E160: the level is not at rest before the first click. */
final class RestCheck {

    /** Steps for which nothing may move before the first click, while a player looks. */
    private static final int LOOKING = Steps.of(3);

    /** Largest movement that is not visible, m: less than a pixel and a half. */
    private static final double SETTLING = 0.015;

    private static final double MILLIMETRES = 1000;

    private RestCheck() {}

    /** Whether nothing moves visibly without a click. */
    static boolean isAtRest(Level level, List<Preset> presets) {
        return presets.stream().map(preset -> looked(level, preset)).allMatch(RestCheck::isAtRest);
    }

    private static boolean isAtRest(PuzzleGame game) {
        List<Ball> balls = game.level().balls();
        return game.pieces().stream().allMatch(piece -> moved(piece) <= SETTLING)
                && IntStream.range(0, balls.size())
                        .allMatch(i -> moved(game.balls().get(i), balls.get(i)) <= SETTLING);
    }

    private static double moved(RigidBody body, Ball ball) {
        return moved(body, ball.x(), ball.y());
    }

    /** Reports which body moves, and how far at the preset at which it moves farthest. */
    static void check(LoadedLevel loaded, Level level, List<Preset> presets) {
        List<PuzzleGame> games = presets.stream().map(preset -> looked(level, preset)).toList();
        for (int i = 0; i < level.balls().size(); i++) {
            Ball ball = level.balls().get(i);
            int at = i;
            double distance = farthest(games, game -> moved(game.balls().get(at), ball));
            report(loaded, i == 0 ? "/ball" : "/moreBalls/" + (i - 1), ball.name(), distance);
        }
        for (int i = 0; i < level.bodies().size(); i++) {
            int at = i;
            double distance = farthest(games, game -> moved(game.pieces().get(at)));
            report(loaded, "/bodies/" + i, "\"" + level.bodies().get(i).id() + "\"", distance);
        }
    }

    private static PuzzleGame looked(Level level, Preset preset) {
        PuzzleGame game = new PuzzleGame(level, preset.accuracy());
        for (int i = 0; i < LOOKING; i++) {
            game.step();
        }
        return game;
    }

    private static double farthest(List<PuzzleGame> games, ToDoubleFunction<PuzzleGame> moved) {
        return games.stream().mapToDouble(moved).max().orElseThrow();
    }

    /** Distance that a piece has moved, m; 0 for a driven one, which is meant to move. */
    private static double moved(Piece piece) {
        if (piece.definition().path().isPresent()) {
            return 0;
        }
        return piece.body().isAlive()
                ? moved(piece.body(), piece.definition().x(), piece.definition().y())
                : Double.POSITIVE_INFINITY;
    }

    private static double moved(RigidBody body, double x, double y) {
        return Length.hypot(body.x() - x, body.y() - y);
    }

    private static void report(LoadedLevel loaded, String pointer, String what, double metres) {
        if (metres > SETTLING) {
            String words = "E160 not at rest before the first click: %s moves by %.0f mm in %.0f s";
            double millimetres = metres * MILLIMETRES;
            String kind = Double.isFinite(metres) ? "E160" : "E160.lost";
            loaded.error(
                    pointer,
                    Fault.of(kind, words, what, millimetres, Steps.seconds(LOOKING))
                            .naming(Math.round(millimetres)));
        }
    }
}
