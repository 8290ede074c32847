package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.Random;

/**
 * A body that nothing holds moves, however weak the push: v = a·t on a smooth floor, whatever its
 * neighbours carry. A body that is held rests to the last bit and is not solved again.
 */
class WeakPushTest {

    private static final Material SMOOTH = new Material(1, 0, 0);
    private static final Material ROUGH = new Material(1, 0.6, 0.1);
    private static final double GRAVITY = 9.81;
    private static final int STEPS = 120;
    private static final double PUSH = 1e-6;

    private static Effects earth(double sideways) {
        return Effects.of(
                new Gravity(sideways, -GRAVITY),
                new Contacts(),
                new Rotation(),
                new Friction(),
                new ContinuousImpacts(),
                new Thrust());
    }

    private static Pool onAFloor(double sideways, Accuracy accuracy, Material material) {
        Pool pool = new Pool(earth(sideways), accuracy);
        pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5).material(material));
        return pool;
    }

    private static BodyDefinition box() {
        return BodyDefinition.dynamic(Polygon.box(1, 1)).material(SMOOTH);
    }

    private static Accuracy accuracy(String name) {
        return name.equals("GAME") ? Accuracy.GAME : Accuracy.EXACT;
    }

    /** Two sums of 120 steps each: round-off only. */
    @ParameterizedTest
    @ValueSource(strings = {"GAME", "EXACT"})
    void gravityThatLeansByAMillionthMovesABox(String preset) {
        Pool pool = onAFloor(PUSH, accuracy(preset), SMOOTH);
        RigidBody body = pool.add(box().at(0, 0.5));
        Scenes.run(pool, STEPS);
        double expected = PUSH * STEPS * Scenes.DT;
        assertThat(body.velocityX()).isEqualTo(expected, within(1e-9 * expected));
    }

    /**
     * The neighbour weighs a million times as much, and both stand on a raft that it presses: a
     * raft that turned by 10⁻¹⁶ rad a second would already give the body a thousandth of the
     * tolerance.
     */
    @ParameterizedTest
    @CsvSource({"GAME, 0, 1e-9", "GAME, 1, 1e-6", "EXACT, 0, 1e-9", "EXACT, 1, 1e-6"})
    void heavyNeighbourDoesNotHoldWhatIsPushedAway(String preset, double raft, double most) {
        Pool pool = onAFloor(0, accuracy(preset), SMOOTH);
        if (raft > 0) {
            BodyDefinition wide = BodyDefinition.dynamic(Polygon.box(8, raft));
            pool.add(wide.at(0, raft / 2).material(SMOOTH));
        }
        pool.add(box().at(-0.5, raft + 0.5).gravityScale(1e6));
        RigidBody body = pool.add(box().at(0.5, raft + 0.5));
        for (int i = 0; i < STEPS; i++) {
            body.applyForce(body.mass() * PUSH, 0, body.x(), body.y());
            pool.step(Scenes.DT);
        }
        double expected = PUSH * STEPS * Scenes.DT;
        assertThat(body.velocityX()).isEqualTo(expected, within(most * expected));
    }

    /**
     * Ten boxes that fell into a trough are not solved again where they lie still. A column may
     * rock on its corner for long, which takes little from it: that one is solved, for it moves.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void smallHeapAtRestIsNotSolvedAgain(int seed) {
        Random random = new Random(seed);
        Pool pool = onAFloor(0, Accuracy.GAME, ROUGH);
        BodyDefinition wall = BodyDefinition.fixed(Polygon.box(1, 40)).material(ROUGH);
        pool.add(wall.at(-2, 20));
        pool.add(wall.at(2, 20));
        for (int i = 0; i < 10; i++) {
            double width = 0.5 + 0.4 * random.nextDouble();
            double height = 0.3 + 0.4 * random.nextDouble();
            double x = i % 2 == 0 ? -0.75 : 0.75;
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(width, height))
                            .at(x, 1 + 1.1 * (i / 2))
                            .angle(6 * random.nextDouble())
                            .material(ROUGH));
        }
        Scenes.run(pool, 420);
        StepReport report = pool.step(Scenes.DT);
        assertThat(report.contacts()).as("seed %d", seed).isGreaterThan(9);
        assertThat(report.contactSolves() == 0 || fastest(pool) > 1e-3)
                .as("seed %d", seed)
                .isTrue();
    }

    private static double fastest(Pool pool) {
        double fastest = 0;
        for (RigidBody body : pool.bodies()) {
            fastest = Math.max(fastest, Math.hypot(body.velocityX(), body.velocityY()));
        }
        return fastest;
    }
}
