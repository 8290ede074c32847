package rigibo.frontend.puzzle.generate;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelBody;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.PuzzleGame;

import java.util.List;
import java.util.stream.Stream;

/** Properties of the parts of plans, for a few draws of each. */
class PlansTest {

    /** Settling that is not visible, m: less than a pixel and a half. */
    private static final double SETTLING = 0.015;

    private static final int DRAWS = 6;
    private static final double LEFT = 0.35;
    private static final double Y = 6;

    static Stream<Start> starts() {
        return Architect.STARTS.stream();
    }

    static Stream<Way> ways() {
        Chance chance = new Chance(3, 0);
        return Stream.of(new DoorWay(chance), new KeepWay(RADIUS), new BridgeWay(chance, RADIUS));
    }

    static Stream<Goal> goals() {
        Chance chance = new Chance(4, 0);
        return Stream.of(new Basin(chance), new LidGoal(chance), new StopGoal(chance));
    }

    private static final double RADIUS = 0.3;

    private static Level level(Plan plan) {
        String text = new Sheet(1, plan).text();
        LoadedLevel loaded = new LevelLoader().parse("plan", text);
        assertThat(loaded.problems().stream().filter(Problem::isError)).as(text).isEmpty();
        return loaded.level().orElseThrow();
    }

    private static void assertStandsStill(Level level) {
        PuzzleGame game = new PuzzleGame(level, Accuracy.GAME);
        for (int i = 0; i < Steps.of(3); i++) {
            game.step();
        }
        for (Piece piece : game.pieces()) {
            LevelBody stated = piece.definition();
            assertThat(moved(piece.body(), stated.x(), stated.y()))
                    .as("%s of %s", stated.id(), level)
                    .isLessThan(SETTLING);
        }
        assertThat(moved(game.balls().get(0), level.balls().get(0).x(), level.balls().get(0).y()))
                .as("the ball of %s", level)
                .isLessThan(SETTLING);
    }

    private static double moved(RigidBody body, double x, double y) {
        return Math.hypot(body.x() - x, body.y() - y);
    }

    @ParameterizedTest
    @MethodSource("starts")
    void everyStartHoldsItsBall(Start start) {
        for (int draw = 0; draw < DRAWS; draw++) {
            Plan plan = new Plan(RADIUS, Substance.STONE);
            Spot end = start.build(plan, new Chance(draw, 0), LEFT, Y);
            new Basin(new Chance(draw, 1)).build(plan, end);
            assertStandsStill(level(plan));
        }
    }

    @ParameterizedTest
    @MethodSource("ways")
    void everyWayStandsStillAndGoesDownByItsLength(Way way) {
        Plan plan = new Plan(RADIUS, Substance.STONE);
        Spot from = new DoorStart().build(plan, new Chance(1, 0), LEFT, Y);
        Spot begin = from.plus(0.5, 0);
        plan.slope(from, begin);
        Spot end = way.build(plan, begin);
        assertThat(end.x()).isEqualTo(begin.x() + way.length());
        assertThat(end.y()).isLessThanOrEqualTo(begin.y());
        new Basin(new Chance(1, 1)).build(plan, end);
        assertStandsStill(level(plan));
    }

    @ParameterizedTest
    @MethodSource("goals")
    void everyGoalStandsStill(Goal goal) {
        Plan plan = new Plan(RADIUS, Substance.STONE);
        Spot end = new DoorStart().build(plan, new Chance(1, 0), LEFT, Y);
        goal.build(plan, end.plus(0.5, 0));
        assertStandsStill(level(plan));
    }

    /** Deleting a door lets the ball roll into a basin, by the rules of the game. */
    @Test
    void openedDoorLetsTheBallRollToTheGoal() {
        Plan plan = new Plan(RADIUS, Substance.STONE);
        Spot end = new DoorStart().build(plan, new Chance(1, 0), LEFT, Y);
        Spot down = end.plus(1, -0.1);
        plan.slope(end, down);
        new Basin(new Chance(1, 1)).build(plan, down);
        PuzzleGame game = new PuzzleGame(level(plan), Accuracy.GAME);
        game.act("door");
        for (int i = 0; i < Steps.of(12); i++) {
            game.step();
        }
        assertThat(game.isSolved()).isTrue();
    }

    @Test
    void turnedPlanIsTheReflectionOfAPlan() {
        Plan plan = new Plan(RADIUS, Substance.STONE);
        plan.box("box", 1, 2, 2, 4);
        plan.turn();
        plan.box("box", 1, 2, 2, 4);
        List<Double> x =
                plan.document()
                        .path("bodies")
                        .valueStream()
                        .map(body -> body.path("x").asDouble())
                        .toList();
        assertThat(x).containsExactly(1.5, Plan.WIDTH - 1.5);
    }
}
