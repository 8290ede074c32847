package rigibo.backend.broadphase;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.PairIndex;

import java.util.Arrays;
import java.util.Random;
import java.util.function.IntPredicate;

/** Results of the fixture store while bodies move, compared with a search of all fixtures. */
class FixtureStoreTest {

    private static final double DT = 1.0 / 60;

    private final FilledStorage world =
            new FilledStorage(
                    new Gravity(0, -9.81),
                    new Contacts(),
                    new ContinuousImpacts(),
                    new Rotation(),
                    new Sleep());
    private final Bodies bodies = world.bodies;

    /**
     * Bodies of sizes up to a ratio, at speeds up to 1,000 m/s, over a floor, near the origin and
     * far out. After each step a search of all fixtures finds the same ones for a fixture, a box
     * and a ray, and movable ones that overlapped in the last search for pairs are a pair.
     */
    @ParameterizedTest
    @CsvSource({"1, 0, 2, 30", "2, 0, 300, 5", "3, 1e7, 10, 30", "4, 0, 2, 1000"})
    void findsWhatBruteForceFinds(long seed, double middle, double ratio, double speed) {
        Random random = new Random(seed);
        world.add(BodyDefinition.fixed(Polygon.box(400, 2)).at(middle, -1));
        for (int i = 0; i < 150; i++) {
            double radius = 0.1 * Math.pow(ratio, random.nextDouble());
            double x = middle + 60 * (random.nextDouble() - 0.5);
            world.add(
                    BodyDefinition.dynamic(new Circle(radius))
                            .at(x, 31 + 60 * random.nextDouble())
                            .velocity(speed * random.nextGaussian(), speed * random.nextGaussian())
                            .spin(random.nextGaussian()));
        }
        for (int step = 0; step < 25; step++) {
            world.step(DT);
            compare(random, "step " + step);
        }
    }

    private void compare(Random random, String when) {
        FixtureStore store = world.broadphase().store();
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            int[] met = met(slot);
            assertThat(numbers(store.meet(slot))).as(when + ", of " + slot).containsExactly(met);
        }
        int about = random.nextInt(bodies.slots.high);
        double x = bodies.x[about];
        double y = bodies.y[about];
        FixtureSearch search = store.search();
        assertThat(numbers(search.query(x - 5, y - 9, x + 5, y + 9)))
                .as(when)
                .containsExactly(overlapping(x - 5, y - 9, x + 5, y + 9));
        assertThat(alongColumn(search.walk(x, -50, x, 200)))
                .as(when)
                .containsExactly(overlapping(x, -50, x, 200));
    }

    private static int[] alongColumn(RayWalk walk) {
        Found found = new Found();
        for (int slot = walk.next(1); slot != RayWalk.END; slot = walk.next(1)) {
            found.add(slot);
        }
        found.sort();
        return numbers(found);
    }

    private int[] met(int slot) {
        return overlapping(
                bodies.fixtureMinX[slot],
                bodies.fixtureMinY[slot],
                bodies.fixtureMaxX[slot],
                bodies.fixtureMaxY[slot]);
    }

    private int[] overlapping(double minX, double minY, double maxX, double maxY) {
        return slots(
                slot ->
                        bodies.fixtureMinX[slot] <= maxX
                                && bodies.fixtureMaxX[slot] >= minX
                                && bodies.fixtureMinY[slot] <= maxY
                                && bodies.fixtureMaxY[slot] >= minY);
    }

    private int[] slots(IntPredicate isMeant) {
        Found found = new Found();
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (isMeant.test(slot)) {
                found.add(slot);
            }
        }
        return numbers(found);
    }

    private static int[] numbers(Found found) {
        return Arrays.copyOf(found.numbers, found.count);
    }

    /**
     * Discs fly apart and meet: after each search for pairs, all overlapping fixtures are pairs.
     */
    @Test
    void fixturesThatMeetArePairs() {
        Random random = new Random(11);
        for (int i = 0; i < 200; i++) {
            world.add(
                    BodyDefinition.dynamic(new Circle(0.3))
                            .at(15 * random.nextDouble(), 15 * random.nextDouble())
                            .velocity(20 * random.nextGaussian(), 20 * random.nextGaussian()));
        }
        int pairs = 0;
        for (int step = 0; step < 100; step++) {
            world.data.beginStep();
            world.broadphase().update(DT);
            for (int slot = 0; slot < 200; slot++) {
                for (int other : met(slot)) {
                    assertThat(slot >= other || areAPair(slot, other))
                            .as("step %s, %s and %s", step, slot, other)
                            .isTrue();
                    pairs += slot < other ? 1 : 0;
                }
                bodies.x[slot] += DT * bodies.velocityX[slot];
                bodies.y[slot] += DT * bodies.velocityY[slot];
            }
        }
        assertThat(pairs).isGreaterThan(1000);
    }

    private boolean areAPair(int one, int other) {
        return world.pairs.index.find(one, other) != PairIndex.ABSENT;
    }

    /** A thousand flyers are in the grid; once asleep they are in the tree and stay there. */
    @Test
    void whatSleepsLeavesTheGrid() {
        world.add(BodyDefinition.fixed(Polygon.box(4000, 2)).at(0, -1));
        for (int i = 0; i < 100; i++) {
            world.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(3 * i, 1.5));
        }
        for (int step = 0; step < 15; step++) {
            world.step(DT);
        }
        assertThat(world.broadphase().store().inGrid()).isEqualTo(100);
        for (int step = 0; step < 300; step++) {
            world.step(DT);
        }
        assertThat(world.data.roster.awakeCount).isZero();
        assertThat(world.broadphase().store().inGrid()).isZero();
    }

    /** While bodies fly, a step examines few boxes for each fixture that it replaces. */
    @Test
    void aCrowdInFlightLooksAtFewBoxes() {
        for (int i = 0; i < 2500; i++) {
            world.add(
                    BodyDefinition.dynamic(Polygon.box(1, 1))
                            .at(2.5 * (i % 50), 2.5 * (i / 50))
                            .velocity(i % 50 / 8.0, i / 50 / 8.0 + 20));
        }
        for (int step = 0; step < 60; step++) {
            world.step(DT);
        }
        // Cells of 4 m, fixtures up to 1.42 + 0.21 + 0.71 + 0.5 m: (2 · 2.84 + 4)² / 6.25 = 15 for
        // each, if each were replaced in each step; they are in every second one.
        assertThat(world.broadphase().store().looked()).isLessThan(60L * 2500 * 15);
    }
}
