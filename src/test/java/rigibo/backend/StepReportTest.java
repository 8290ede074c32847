package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.Material;
import rigibo.backend.setup.SolveMethod;

/** The report tells how an island got its answer, and what became of bounces. */
class StepReportTest {

    private static Pool withBox(Accuracy accuracy) {
        Pool pool = new Pool(Scenes.usualWithoutSleep(), accuracy);
        Scenes.addFloor(pool);
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.5));
        return pool;
    }

    private static Pool withBall(double gravity, double height, double elasticity) {
        Effects effects =
                Effects.of(
                        new Gravity(0, -gravity),
                        new Contacts(),
                        new ContinuousImpacts(),
                        new Restitution());
        Pool pool = new Pool(effects, Accuracy.GAME.withMaxImpactsPerPair(4));
        Scenes.addFloor(pool);
        pool.add(
                BodyDefinition.dynamic(new Circle(0.5))
                        .at(0, 0.5 + height)
                        .material(new Material(1, 0, elasticity)));
        return pool;
    }

    private static void assertOneIslandBy(SolveMethod expected, StepReport report) {
        int rows = 0;
        for (SolveMethod method : SolveMethod.values()) {
            assertThat(report.islands(method)).isEqualTo(method == expected ? 1 : 0);
            rows += report.rows(method);
        }
        assertThat(rows).isEqualTo(report.rows());
        assertThat(report.rows(expected)).isEqualTo(report.rows());
    }

    @Test
    void smallIslandIsSolvedByEliminationUntilItRests() {
        Pool pool = withBox(Accuracy.GAME);
        StepReport report = pool.step(Scenes.DT);
        assertOneIslandBy(SolveMethod.ELIMINATION, report);
        assertThat(report.rows()).isPositive();
        Scenes.run(pool, 10);
        assertOneIslandBy(SolveMethod.AT_REST, report);
        assertThat(report.rows()).isZero();
    }

    @Test
    void withoutDirectSolvesAnIslandIsSolvedInPasses() {
        Pool pool = withBox(Accuracy.GAME.withContactSolver(ContactSolver.BLOCK));
        assertOneIslandBy(SolveMethod.PASSES, pool.step(Scenes.DT));
    }

    /** From a fifth of g·dt/2 a ball that loses nothing bounces five times in a step, not four. */
    @Test
    void ballThatBouncesOftenerThanItMayIsTold() {
        double gravity = 1e4;
        double speed = gravity * Scenes.DT / 2 / 5;
        Pool pool = withBall(gravity, speed * speed / (2 * gravity), 1);
        assertThat(pool.step(Scenes.DT).cappedPairs()).isEqualTo(1);
        assertThat(pool.report().settledPairs()).isZero();
    }

    /** From 0.1 m with e = ½ bounces end after t₁(1 + e)/(1 − e) = 0.43 s, once. */
    @Test
    void endOfTheBouncesIsToldOnce() {
        Pool pool = withBall(9.81, 0.1, 0.5);
        int settled = 0;
        int capped = 0;
        for (int i = 0; i < 60; i++) {
            settled += pool.step(Scenes.DT).settledPairs();
            capped += pool.report().cappedPairs();
        }
        assertThat(settled).isEqualTo(1);
        assertThat(capped).isZero();
    }
}
