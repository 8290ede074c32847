package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.SplittableRandom;
import java.util.function.BiConsumer;

/** What drives, strikes or turns joints fast leaves them closed and gives them no energy. */
@Execution(ExecutionMode.CONCURRENT)
class FastJointsTest {

    /** Limit of J1 at GAME for a joint's error, m. */
    private static final double OPEN = 1e-4;

    /** Limit of J1 at GAME for energy, as a share. */
    private static final double SHARE = 1e-3;

    private static double worstError(Pool pool) {
        return pool.joints().stream().mapToDouble(Joint::error).max().orElse(0);
    }

    /** A motor of any torque turns its bar by a radian in the first step and more. */
    @ParameterizedTest
    @ValueSource(doubles = {60, -100, 150, 300})
    void motorsStartAtOnce(double speed) {
        Pool pool = new Pool(JointScenes.SPACE, Accuracy.GAME);
        RigidBody hook = JointScenes.hook(pool, 0, 0);
        RigidBody bar = pool.add(BodyDefinition.dynamic(Polygon.box(0.2, 0.5)).at(0, -0.25));
        pool.join(RevoluteJoint.at(hook, bar, 0, 0).motor(speed, 1e9));
        for (int step = 0; step < 30; step++) {
            pool.step(Scenes.DT);
            assertThat(worstError(pool)).as("step " + step).isLessThan(OPEN);
        }
        assertThat(Math.abs(bar.angularVelocity() - speed)).isLessThan(SHARE * Math.abs(speed));
    }

    /** Two discs circle each other on a spring that turns in a step by up to half a turn. */
    @ParameterizedTest
    @CsvSource({
        "GAME, 30, 25",
        "GAME, 100, 40",
        "GAME, 100, 100",
        "GAME, 100, 400",
        "GAME, 150, 1000",
        "DRAFT, 10, 20",
        "DRAFT, 30, 20",
        "DRAFT, 100, 40"
    })
    void springsThatTurnGainNoEnergy(String preset, double rate, double hertz) {
        Accuracy accuracy = preset.equals("GAME") ? Accuracy.GAME : Accuracy.DRAFT;
        Pool pool = new Pool(JointScenes.SPACE, accuracy);
        RigidBody upper = disc(pool, 0.3, rate);
        RigidBody lower = disc(pool, -0.3, rate);
        pool.join(DistanceJoint.rod(upper, 0, 0.3, lower, 0, -0.3).spring(hertz, 0));
        double start = JointScenes.energy(pool);
        for (int step = 0; step < 60; step++) {
            pool.step(Scenes.DT);
            assertThat(JointScenes.energy(pool) / start).as("step " + step).isLessThan(1 + SHARE);
        }
    }

    private static RigidBody disc(Pool pool, double y, double rate) {
        return pool.add(
                BodyDefinition.dynamic(new Circle(0.1)).at(0, y).velocity(-rate * y, 0).group(1));
    }

    /**
     * Balls of 0.1 to 10 kg strike a bar of 0.2 kg at 10 to 100 m/s that is geared to another one.
     * Once they have parted, nothing does any work.
     */
    @ParameterizedTest
    @ValueSource(doubles = {-2, 0.5, 1, 1.7})
    void gearsOfAStruckBarStayClosed(double ratio) {
        strikeBars(
                7,
                (pool, hinge) -> {
                    RigidBody other = bar(pool, -1.3);
                    Joint second = pool.join(RevoluteJoint.at(hinge.a(), other, 0, -1.3));
                    pool.join(GearJoint.of(hinge, second, ratio));
                });
    }

    /** The hinge of the bar has elastic limits, which it strikes as well. */
    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.5, 1.1})
    void limitsOfAStruckBarStayClosed(double limit) {
        strikeBars(
                8,
                (pool, hinge) ->
                        hinge.settings(hinge.definition().limits(-limit, limit, 1).settings()));
    }

    /** Strikes forty bars, each on a hinge that is completed beforehand. */
    private static void strikeBars(long seed, BiConsumer<Pool, Joint> complete) {
        SplittableRandom random = new SplittableRandom(seed);
        int struck = 0;
        for (int i = 0; i < 40; i++) {
            Pool pool = new Pool(JointScenes.SPACE, Accuracy.GAME);
            RigidBody hook = JointScenes.hook(pool, 0, 0.5);
            complete.accept(pool, pool.join(RevoluteJoint.at(hook, bar(pool, 0.2), 0, 0.5)));
            struck += strike(pool, random, 0.4 * random.nextDouble() - 0.1, i);
        }
        assertThat(struck).isGreaterThanOrEqualTo(40);
    }

    private static RigidBody bar(Pool pool, double y) {
        return pool.add(
                BodyDefinition.dynamic(Polygon.box(0.2, 0.6))
                        .at(0, y)
                        .mass(0.2)
                        .group(1)
                        .material(new Material(1000, 0, 0.9)));
    }

    /** Strikes the bar at a height in m; returns the number of impacts. */
    private static int strike(Pool pool, SplittableRandom random, double y, int draw) {
        double mass = Math.pow(10, 2 * random.nextDouble() - 1);
        double speed = Math.pow(10, 1 + random.nextDouble());
        double away = 0.35 + (1 + random.nextDouble()) * speed * Scenes.DT;
        pool.add(
                BodyDefinition.dynamic(new Circle(0.1))
                        .at(-away, y)
                        .velocity(speed, 0)
                        .mass(mass)
                        .material(new Material(1000, 0, 0.9)));
        int impacts = 0;
        double energy = pool.kineticEnergy();
        for (int step = 0; step < 20; step++) {
            pool.step(Scenes.DT);
            String of = draw + ": " + mass + " kg at " + speed + " m/s, step " + step;
            impacts += pool.report().impacts();
            double now = pool.kineticEnergy();
            double least = pool.report().impacts() > 0 ? 0 : energy * (1 - SHARE);
            assertThat(now).as(of).isBetween(least, energy * (1 + SHARE));
            assertThat(worstError(pool)).as(of).isLessThan(OPEN);
            energy = now;
        }
        return impacts;
    }
}
