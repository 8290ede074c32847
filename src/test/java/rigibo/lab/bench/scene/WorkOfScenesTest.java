package rigibo.lab.bench.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.setup.Accuracy;
import rigibo.lab.child.Work;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.World;

/**
 * The work of our steps, in counters that depend on no clock, within bounds that follow from
 * geometry. So a step that does more than its scene calls for is found on any machine.
 */
class WorkOfScenesTest {

    /** Rows a contact may need: two points with a normal and friction each. */
    private static final int ROWS_PER_CONTACT = 4;

    private static Work afterSteps(Scene scene, int steps) {
        try (World world = RigiBoEngine.world(scene.effects(), Accuracy.GAME)) {
            scene.build(world);
            for (int i = 0; i < steps; i++) {
                scene.driver().drive(world, i);
                scene.loss().befall(world, i);
                world.step(Scene.STEP);
            }
            return world.lastStep();
        }
    }

    /**
     * The boxes of the base carry the floor's n contacts, every other one lies on two; beside each
     * other boxes may touch, n − 1 pairs in a row of n. All others are half a box apart at least,
     * so that fixtures laid a quarter of a box around them would not meet either.
     */
    @ParameterizedTest
    @ValueSource(ints = {2, 10, 20})
    void pyramidHasTheContactsThatCarryItAndNoOtherPairs(int base) {
        Work work = afterSteps(Pyramids.one(base), 60);
        assertCarried(work, base, 1);
    }

    @Test
    void pyramidsOfAFieldKnowNothingOfEachOther() {
        assertCarried(afterSteps(Pyramids.field(2, 3, 5), 60), 5, 6);
    }

    /**
     * Bodies that leaned on the lost box wake in the same step, with no more work than if they had
     * been awake.
     */
    @Test
    void sleepersThatLoseABoxAreAsMuchWorkAsIfTheyHadBeenAwake() {
        int settling = 120;
        Work asleep = afterSteps(Pyramids.undermined(20, settling, Pyramids.withSleep()), settling);
        assertThat(asleep.contacts()).isZero();
        Work woken =
                afterSteps(Pyramids.undermined(20, settling, Pyramids.withSleep()), settling + 1);
        Work awake =
                afterSteps(
                        Pyramids.undermined(20, settling, Pyramids.withoutSleep()), settling + 1);
        assertThat(woken).isEqualTo(awake);
        assertThat(woken.rows()).isPositive();
    }

    private static void assertCarried(Work work, int base, int pyramids) {
        int above = base * (base - 1) / 2;
        long carrying = (long) pyramids * (base + 2 * above);
        long beside = (long) pyramids * above;
        assertThat(work.contacts()).isBetween(carrying, carrying + beside);
        assertThat(work.pairs()).isBetween(work.contacts(), carrying + beside);
        // A body that its loads keep at rest is not solved again.
        assertThat(work.rows()).isZero();
        assertThat(work.impacts()).isZero();
        assertThat(work.evaluations()).isZero();
    }

    /**
     * Bodies that touch without overlapping, joined at their contacts, are a planar graph: no more
     * than 3v − 6 edges (Euler). A fixture reaches no more than a radius beyond its disc, so that
     * two whose fixtures meet have centres within 4r along both axes, and into a square of 10r
     * discs fit 28 times at the density of the closest packing, 0.9069: 14 pairs a disc, and three
     * walls.
     */
    @ParameterizedTest
    @ValueSource(ints = {20, 60, 180})
    void floodHasAsManyContactsAsAPlaneHolds(int steps) {
        int discs = 300;
        Work work = afterSteps(Floods.asDeepAsAny(discs), steps);
        assertThat(work.contacts()).isLessThanOrEqualTo(3 * (discs + 3) - 6);
        assertThat(work.pairs()).isBetween(work.contacts(), 14L * discs + 3 * discs);
        assertThat(work.rows()).isBetween(0L, ROWS_PER_CONTACT * work.pairs());
    }

    /** Each disc that lies is held by two others or walls at least, but for chance. */
    @Test
    void floodThatLiesIsHeld() {
        int discs = 300;
        assertThat(afterSteps(Floods.asDeepAsAny(discs), 300).contacts())
                .isGreaterThan(3 * discs / 2);
    }

    /**
     * As for discs, but boxes with half a diagonal R = 0.177 m for a radius: centres within 4R, and
     * a square of 10R is 50 times the area of a box; and four walls.
     */
    @ParameterizedTest
    @ValueSource(ints = {30, 120, 300})
    void tumblerHasAsManyContactsAsAPlaneHolds(int steps) {
        int boxes = 100;
        Work work = afterSteps(Tumbler.of(10), steps);
        assertThat(work.contacts()).isLessThanOrEqualTo(3 * (boxes + 4) - 6);
        assertThat(work.pairs()).isBetween(work.contacts(), 25L * boxes + 4 * boxes);
    }

    /**
     * They part sideways, and one above the other fly 0.6 m in a step through a gap of 1.5 m:
     * fixtures may meet along columns, once a body, and nothing else may be asked of a step.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 60, 300})
    void nothingIsDoneForWhatFliesFreely(int steps) {
        int boxes = 400;
        Work work = afterSteps(Flyers.of(boxes), steps);
        assertThat(work.pairs()).isLessThanOrEqualTo(boxes);
        assertThat(work.contacts()).isZero();
        assertThat(work.rows()).isZero();
        assertThat(work.impacts()).isZero();
    }
}
