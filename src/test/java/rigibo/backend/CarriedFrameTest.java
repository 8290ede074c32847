package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.backend.setup.SolveMethod;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** A pile on a floor of constant velocity behaves as on a floor at rest. */
class CarriedFrameTest {

    private static final Material ROUGH = new Material(1, 0.6, 0);
    private static final Material SMOOTH = new Material(1, 0, 0);
    private static final Gravity EARTH = new Gravity(0, -9.81);
    private static final Effects PILES =
            Effects.of(
                    EARTH, new Contacts(), new Rotation(), new Friction(), new ContinuousImpacts());

    /** Bodies of a pit: floor, left wall, right wall. */
    private static final int PIT = 3;

    /** Five boxes that touch rest from the first steps on, and none leaves its place or parts. */
    @ParameterizedTest
    @CsvSource({"0.5, 0", "-5, 0", "50, 0", "0, 3", "0, -3", "-30, 20"})
    void stackRestsOnAFloorThatMoves(double x, double y) {
        Pool pool = new Pool(PILES, Accuracy.GAME);
        RigidBody floor = floor(pool, ROUGH, x, y);
        List<RigidBody> stack = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            stack.add(pool.add(box(ROUGH).at(0, i + 0.5).velocity(x, y)));
        }
        Scenes.run(pool, 60);
        pool.step(Scenes.DT);

        assertThat(pool.report().islands(SolveMethod.AT_REST)).isEqualTo(1);
        for (int i = 0; i < stack.size(); i++) {
            // Places go to 60 m: round-off of the ways of a hundred steps.
            assertThat(stack.get(i).x() - floor.x()).isEqualTo(0, within(1e-12));
            assertThat(stack.get(i).y() - floor.y()).isEqualTo(i + 1, within(1e-12));
            assertThat(stack.get(i).velocityX()).isEqualTo(x);
            assertThat(stack.get(i).velocityY()).isEqualTo(y);
        }
    }

    /**
     * A pyramid that falls together from gaps, storey upon storey, meets the same impacts in the
     * same order on either floor: places differ by round-off of places up to 60 m, 10⁻¹⁴ m each,
     * which a few hundred impacts make a hundred times more of; work does not differ at all.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 5, 50})
    void pyramidSettlesOnAFloorThatMoves(double speed) {
        Pool standing = new Pool(PILES, Accuracy.GAME);
        floor(standing, ROUGH, 0, 0);
        List<RigidBody> rest = settling(standing, 7, 0);
        Pool moving = new Pool(PILES, Accuracy.GAME);
        RigidBody floor = floor(moving, ROUGH, speed, 0);
        List<RigidBody> carried = settling(moving, 7, speed);
        for (int step = 1; step <= 60; step++) {
            standing.step(Scenes.DT);
            moving.step(Scenes.DT);
            for (int i = 0; i < rest.size(); i++) {
                double x = carried.get(i).x() - floor.x();
                assertThat(x).as("step %d", step).isEqualTo(rest.get(i).x(), within(1e-10));
                assertThat(carried.get(i).y()).isEqualTo(rest.get(i).y(), within(1e-10));
            }
            assertThat(moving.report().impacts()).isEqualTo(standing.report().impacts());
            assertThat(moving.report().contactSolves())
                    .as("contacts solved in step %d", step)
                    .isEqualTo(standing.report().contactSolves());
        }
    }

    /** A pyramid with gaps of 1 cm under every storey. */
    private static List<RigidBody> settling(Pool pool, int base, double speed) {
        List<RigidBody> boxes = new ArrayList<>();
        for (int storey = 0; storey < base; storey++) {
            for (int i = 0; i < base - storey; i++) {
                double x = i - (base - storey - 1) / 2.0;
                double y = 0.5 + storey + 0.01 * (storey + 1);
                boxes.add(pool.add(box(ROUGH).at(x, y).velocity(speed, 0)));
            }
        }
        return boxes;
    }

    /**
     * A heap that lay still is let go on either floor: it gives way by the micrometres that its
     * overlaps and gaps leave it, and lies again. Contacts are solved in the same order on both,
     * for in a heap that order decides what passes leave. Places differ by round-off of places up
     * to 60 m, 7·10⁻¹⁵ m, which rows that nearly repeat each other multiply by up to a million
     * where the last of an overlap is taken back at once.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void heapLiesOnAFloorThatMoves(long seed) {
        Pool pool = new Pool(PILES, Accuracy.GAME);
        List<BodyDefinition> falling = boxes(seed);
        List<RigidBody> fallen = heap(pool, falling, 0);
        Scenes.run(pool, 600);
        List<BodyDefinition> lying = new ArrayList<>();
        for (int i = 0; i < falling.size(); i++) {
            RigidBody body = fallen.get(PIT + i);
            lying.add(falling.get(i).at(body.x(), body.y()).angle(body.angle()));
        }
        Pool standing = new Pool(PILES, Accuracy.GAME);
        List<RigidBody> rest = heap(standing, lying, 0);
        Pool moving = new Pool(PILES, Accuracy.GAME);
        List<RigidBody> carried = heap(moving, lying, 50);
        for (int step = 1; step <= 60; step++) {
            standing.step(Scenes.DT);
            moving.step(Scenes.DT);
            for (int i = PIT; i < rest.size(); i++) {
                double x = carried.get(i).x() - carried.get(0).x();
                assertThat(x)
                        .as("seed %d, step %d, body %d", seed, step, i)
                        .isEqualTo(rest.get(i).x(), within(1e-8));
                assertThat(carried.get(i).y()).isEqualTo(rest.get(i).y(), within(1e-8));
            }
            assertThat(moving.report().contactSolves())
                    .as("seed %d, contacts solved in step %d", seed, step)
                    .isEqualTo(standing.report().contactSolves());
        }
    }

    /** Boxes of many sizes at any angle, in rows of three. */
    private static List<BodyDefinition> boxes(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<BodyDefinition> boxes = new ArrayList<>();
        for (int i = 0; i < 15; i++) {
            Polygon shape =
                    Polygon.box(0.5 + 0.3 * random.nextDouble(), 0.3 + 0.3 * random.nextDouble());
            boxes.add(
                    BodyDefinition.dynamic(shape)
                            .at(i % 3 - 1, 0.6 + i / 3)
                            .angle(Math.PI * random.nextDouble())
                            .material(ROUGH));
        }
        return boxes;
    }

    /** A floor and two walls that move alike, or stand, and what they carry. */
    private static List<RigidBody> heap(Pool pool, List<BodyDefinition> boxes, double speed) {
        List<RigidBody> bodies = new ArrayList<>();
        bodies.add(pool.add(driven(Polygon.box(8, 1), speed).at(0, -0.5)));
        bodies.add(pool.add(driven(Polygon.box(1, 8), speed).at(-2, 4)));
        bodies.add(pool.add(driven(Polygon.box(1, 8), speed).at(2, 4)));
        boxes.forEach(box -> bodies.add(pool.add(box.velocity(speed, 0))));
        return bodies;
    }

    private static BodyDefinition driven(Polygon shape, double speed) {
        return speed == 0
                ? BodyDefinition.fixed(shape).material(ROUGH)
                : BodyDefinition.kinematic(shape).velocity(speed, 0).material(ROUGH);
    }

    /** A wall that stands holds what the floor drags against it, and no frame hides that. */
    @Test
    void whatLeansOnAWallThatStandsIsSeenFromTheWorld() {
        Pool pool = new Pool(PILES, Accuracy.GAME);
        floor(pool, ROUGH, 2, 0);
        pool.add(BodyDefinition.fixed(Polygon.box(1, 2)).at(1, 1).material(SMOOTH));
        RigidBody box = pool.add(box(ROUGH).at(0, 0.5));
        Scenes.run(pool, 60);
        // A driven body yields by a hundredth of g·h, which overlap recovery takes back.
        assertThat(box.x()).isEqualTo(0, within(1e-4));
        assertThat(box.velocityX()).isEqualTo(0, within(1e-4));
    }

    /** Air stands still while the floor moves: v = v₀·e^(−kt) on a smooth one. */
    @Test
    void dragIsThatOfTheWorld() {
        Effects effects = Effects.of(EARTH, new Contacts(), new Drag(), new ContinuousImpacts());
        Pool pool = new Pool(effects, Accuracy.GAME);
        floor(pool, SMOOTH, 5, 0);
        RigidBody box = pool.add(box(SMOOTH.drag(0.7)).at(0, 0.5).velocity(5, 0));
        Scenes.run(pool, 60);
        assertThat(box.velocityX()).isEqualTo(5 * Math.exp(-0.7), within(1e-12));
    }

    /**
     * A spring of ω = 2 rad/s is fixed to the world while a smooth floor moves: x = v/ω·sin ωt. The
     * leapfrog of four substeps is off by a share of (ωh)²/24 = 3e-6.
     */
    @Test
    void forcesByPlaceAreThoseOfTheWorld() {
        Field spring = new Field(point -> point.accelerate(-4 * point.x, 0));
        Effects effects = Effects.of(EARTH, new Contacts(), spring, new ContinuousImpacts());
        Pool pool = new Pool(effects, Accuracy.GAME);
        floor(pool, SMOOTH, 5, 0);
        RigidBody box = pool.add(box(SMOOTH).at(0, 0.5).velocity(5, 0));
        for (int i = 1; i <= 60; i++) {
            pool.step(Scenes.DT);
            double truth = 2.5 * Math.sin(2 * pool.time());
            assertThat(box.x()).as("step %d", i).isEqualTo(truth, within(1e-4));
        }
    }

    private static RigidBody floor(Pool pool, Material material, double x, double y) {
        return pool.add(
                BodyDefinition.kinematic(Polygon.box(40, 1))
                        .at(0, -0.5)
                        .velocity(x, y)
                        .material(material));
    }

    private static BodyDefinition box(Material material) {
        return BodyDefinition.dynamic(Polygon.box(1, 1)).material(material);
    }
}
