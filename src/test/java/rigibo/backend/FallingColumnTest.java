package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Discs that fall one behind the other onto a floor. Those that have landed are stopped within a
 * step, and what follows must not go into them.
 */
class FallingColumnTest {

    private static final Effects AWAKE = Effects.usual().without(Sleep.class);
    private static final Material STONE = new Material(1, 0.6, 0.1);

    /** A floor at a velocity, and so many discs over it that move along. */
    private static List<RigidBody> column(
            Pool pool, int count, long seed, Material material, double x, double y) {
        List<RigidBody> bodies = new ArrayList<>();
        SplittableRandom random = new SplittableRandom(seed);
        Polygon floor = Polygon.box(20, 1);
        bodies.add(pool.add(BodyDefinition.kinematic(floor).at(0, -0.5).velocity(x, y)));
        for (int i = 0; i < count; i++) {
            Circle disc = new Circle(0.2 + 0.15 * random.nextDouble());
            BodyDefinition body = BodyDefinition.dynamic(disc).at(0, 1.2 * (i + 1));
            bodies.add(pool.add(body.velocity(x, y).material(material)));
        }
        return bodies;
    }

    /** Deepest overlap of two neighbours in widths of the smaller one. */
    private static double deepest(List<RigidBody> column) {
        double deepest = 0;
        for (int i = 2; i < column.size(); i++) {
            RigidBody lower = column.get(i - 1);
            RigidBody upper = column.get(i);
            double ofLower = ((Circle) lower.shape()).radius();
            double ofUpper = ((Circle) upper.shape()).radius();
            double apart = Math.hypot(upper.x() - lower.x(), upper.y() - lower.y());
            double depth = (ofLower + ofUpper - apart) / (2 * Math.min(ofLower, ofUpper));
            deepest = Math.max(deepest, depth);
        }
        return deepest;
    }

    /** M1 allows crowds of up to 400 bodies, which stand in such columns, 0.05 widths. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void isNotEnteredByWhatFollows(long seed) {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        List<RigidBody> column = column(pool, 24, seed, STONE, 0, 0);
        double deepest = 0;
        for (int i = 0; i < 150; i++) {
            pool.step(Scenes.DT);
            deepest = Math.max(deepest, deepest(column));
        }
        assertThat(deepest).isLessThan(0.05);
    }

    /** M8: the same picture to 1e-6 m for a second, whichever way the floor goes. */
    @ParameterizedTest
    @CsvSource({"50, 0", "0, 3", "0, -20"})
    void fallsAlikeInAllFrames(double x, double y) {
        Pool standing = new Pool(AWAKE, Accuracy.GAME);
        List<RigidBody> rest = column(standing, 8, 1, STONE, 0, 0);
        Pool moving = new Pool(AWAKE, Accuracy.GAME);
        List<RigidBody> carried = column(moving, 8, 1, STONE, x, y);
        for (int step = 1; step <= 60; step++) {
            standing.step(Scenes.DT);
            moving.step(Scenes.DT);
            for (int i = 1; i < rest.size(); i++) {
                double height = carried.get(i).y() - carried.get(0).y();
                double truth = rest.get(i).y() - rest.get(0).y();
                assertThat(height).as("step %d, disc %d", step, i).isEqualTo(truth, within(1e-6));
            }
        }
    }

    /**
     * Each disc is told as it strikes the one below, no faster than it can fall, whether or not it
     * joined the pile before.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void everyDiscIsToldAsItStrikes(long seed) {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        List<RigidBody> column = column(pool, 12, seed, STONE, 0, 0);
        boolean[] isTold = new boolean[column.size()];
        double fastest = Math.sqrt(2 * 9.81 * 1.2 * 12);
        for (int i = 0; i < 150; i++) {
            pool.step(Scenes.DT);
            for (HitEvent hit : pool.hits()) {
                int upper = Math.max(column.indexOf(hit.a()), column.indexOf(hit.b()));
                isTold[upper] |= hit.speed() > 1;
                assertThat(hit.speed()).isLessThan(fastest);
                assertThat(hit.time()).isBetween(0.0, Scenes.DT);
            }
        }
        for (int i = 1; i < isTold.length; i++) {
            assertThat(isTold[i]).as("disc %d", i).isTrue();
        }
    }
}
