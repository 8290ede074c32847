package rigibo.backend.rest;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;

/** Half a second within 1/64 m, in steps of an eighth: numbers are exact. */
class SleepingTest {

    private static final double DISTANCE = 1.0 / 64;
    private static final Sleep SLEEP = new Sleep(0.5, DISTANCE);
    private static final double DT = 0.125;
    private static final int STEPS = 4;

    private final Pile pile = new Pile(new Contacts(), new Rotation(), SLEEP);
    private final Bodies bodies = pile.bodies;

    private final int floor = pile.body(BodyType.STATIC);
    private final int lower = piled();
    private final int upper = piled();

    private int piled() {
        int slot = pile.body(BodyType.DYNAMIC);
        bodies.piled[slot] = true;
        return slot;
    }

    SleepingTest() {
        pile.contact(floor, lower, 2);
        pile.contact(lower, upper, 2);
    }

    /** So many steps at the end of which nothing has moved. */
    private void rest(int steps) {
        rest(pile, steps);
    }

    private static void rest(Pile pile, int steps) {
        Sleeping sleeping = new Sleeping(pile.data, SLEEP);
        for (int i = 0; i < steps; i++) {
            pile.accept();
            new IslandBuilder(pile.data).build();
            sleeping.settle(DT);
        }
    }

    /** Two islands side by side are measured each by itself. */
    @Test
    void islandsSleepEachInItsTime() {
        int third = piled();
        int fourth = piled();
        pile.contact(third, fourth, 2);
        rest(1);
        for (int slot : new int[] {lower, upper, third, fourth}) {
            assertThat(bodies.stillTime[slot]).isEqualTo(DT);
        }
        bodies.stillTime[third] = 0;
        rest(STEPS - 1);
        pile.requireAwake(false, lower, upper);
        pile.requireAwake(true, third, fourth);
        rest(1);
        pile.requireAwake(false, third, fourth);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.25, 2, 8})
    void sleepsAfterWhateverTimeIsDeclared(double seconds) {
        Sleeping sleeping = new Sleeping(pile.data, new Sleep(seconds, DISTANCE));
        pile.accept();
        new IslandBuilder(pile.data).build();
        for (double time = DT; time < seconds; time += DT) {
            sleeping.settle(DT);
        }
        pile.requireAwake(true, lower, upper);
        sleeping.settle(DT);
        pile.requireAwake(false, lower, upper);
    }

    @Test
    void sleepsAfterTheTimeAndNotBefore() {
        rest(STEPS - 1);
        pile.requireAwake(true, lower, upper);
        rest(1);
        pile.requireAwake(false, lower, upper);
        assertThat(pile.data.roster.isStale).isTrue();
    }

    /** Residual motion is removed, since it would come back on waking. */
    @Test
    void whatFallsAsleepStandsStill() {
        rest(STEPS - 1);
        bodies.velocityX[lower] = 1e-5;
        bodies.velocityY[upper] = -1e-5;
        bodies.spin[upper] = 1e-5;
        rest(1);

        for (int slot : new int[] {lower, upper}) {
            assertThat(bodies.velocityX[slot]).isZero();
            assertThat(bodies.velocityY[slot]).isZero();
            assertThat(bodies.spin[slot]).isZero();
        }
    }

    @Test
    void oneRestlessBodyKeepsItsIslandAwake() {
        int apart = piled();
        for (int i = 0; i < 3 * STEPS; i++) {
            bodies.x[upper] += 2 * DISTANCE;
            rest(1);
        }
        pile.requireAwake(true, lower, upper);
        pile.requireAwake(false, apart);
    }

    /** It is the island's stillest time that counts, whichever of its bodies has it. */
    @Test
    void whoMovedLastDecidesWhen() {
        rest(2);
        bodies.y[lower] += 2 * DISTANCE;
        rest(STEPS);
        pile.requireAwake(true, lower, upper);
        rest(1);
        pile.requireAwake(false, lower, upper);
    }

    /** 5/4 of the distance, aslant: 3/4 and 4/4 of it, each of which alone would be within. */
    @Test
    void displacementIsInAnyDirection() {
        rest(STEPS - 1);
        bodies.x[lower] = 0.75 * DISTANCE;
        bodies.y[lower] = -DISTANCE;
        rest(1);
        pile.requireAwake(true, lower, upper);
    }

    /** However slow: what slides for good leaves any place at last. */
    @Test
    void whatSlidesSlowlyStaysAwake() {
        double perStep = DISTANCE / 2.5;
        for (int i = 0; i < 10 * STEPS; i++) {
            bodies.x[upper] += perStep;
            rest(1);
        }
        pile.requireAwake(true, lower, upper);
    }

    @Test
    void whatTremblesInPlaceSleeps() {
        for (int i = 0; i < STEPS; i++) {
            bodies.x[upper] = (i % 2 == 0 ? 1 : -1) * DISTANCE;
            rest(1);
        }
        pile.requireAwake(false, lower, upper);
    }

    /** Farthest points 1 m and 4 m away: the angle counts by how far it moves them. */
    @ParameterizedTest(name = "turned by {0} rad, {1} m far: awake is {2}")
    @CsvSource({
        "0.015625, 1, false",
        "-0.015625, 1, false",
        "0.02, 1, true",
        "-0.02, 1, true",
        "0.00390625, 4, false",
        "0.005, 4, true",
        "-0.005, 4, true"
    })
    void turningAloneKeepsAwake(double angle, double farthest, boolean isAwake) {
        bodies.boundingRadius[upper] = farthest;
        rest(STEPS - 1);
        bodies.angle[upper] = angle;
        rest(1);
        pile.requireAwake(isAwake, lower, upper);
    }

    /** Half of the distance each way is within, a bit more is not. */
    @Test
    void turningAddsToMoving() {
        rest(STEPS - 1);
        bodies.x[upper] = DISTANCE / 2;
        bodies.angle[upper] = -0.51 * DISTANCE;
        rest(1);
        pile.requireAwake(true, lower, upper);
        bodies.x[upper] += DISTANCE / 2;
        bodies.angle[upper] += DISTANCE / 2;
        rest(STEPS);
        pile.requireAwake(false, lower, upper);
    }

    @Test
    void thresholdsScaleWithTheBody() {
        bodies.smallestWidth[lower] = 8;
        bodies.smallestWidth[upper] = 0.5;
        rest(STEPS - 1);
        bodies.x[lower] = 8 * DISTANCE;
        bodies.x[upper] = DISTANCE / 2;
        rest(1);
        pile.requireAwake(false, lower, upper);
    }

    @Test
    void whatIsSmallStraysLess() {
        bodies.smallestWidth[upper] = 0.5;
        rest(STEPS - 1);
        bodies.x[upper] = 0.51 * DISTANCE;
        rest(1);
        pile.requireAwake(true, lower, upper);
    }

    /**
     * Every way to be driven; one that stands still lets sleep, as one that is not touched does.
     */
    @ParameterizedTest(name = "at {0}, {1} m/s and {2} rad/s with {3} points: awake is {4}")
    @CsvSource({
        "1, 0, 0, 1, true",
        "0, -1, 0, 1, true",
        "0, 0, 1, 2, true",
        "0, 0, 0, 1, false",
        "1, 0, 0, 0, false"
    })
    void aDrivenNeighbourKeepsAwakeWhileItMoves(
            double x, double y, double spin, int points, boolean isAwake) {
        int lift = pile.body(BodyType.KINEMATIC);
        bodies.velocityX[lift] = x;
        bodies.velocityY[lift] = y;
        bodies.spin[lift] = spin;
        pile.contact(upper, lift, points);
        rest(STEPS);

        pile.requireAwake(isAwake, lower, upper);
    }

    @Test
    void aDrivenNeighbourOfTheLowerSlotKeepsAwake() {
        Pile other = new Pile(new Contacts(), new Rotation(), SLEEP);
        int belt = other.body(BodyType.KINEMATIC);
        other.bodies.velocityX[belt] = 1;
        int box = other.body(BodyType.DYNAMIC);
        other.bodies.piled[box] = true;
        other.contact(belt, box, 2);
        rest(other, 2 * STEPS);
        assertThat(other.bodies.awake[box]).isTrue();

        other.bodies.velocityX[belt] = 0;
        rest(other, 1);
        assertThat(other.bodies.awake[box]).as("the belt stands, and the box has long").isFalse();
    }

    /** A driven neighbour keeps its own island awake, and no other. */
    @Test
    void islandsSleepEachByItself() {
        int lift = pile.body(BodyType.KINEMATIC);
        bodies.velocityY[lift] = 1;
        int carried = piled();
        pile.contact(lift, carried, 2);
        int last = piled();
        rest(STEPS);

        pile.requireAwake(false, lower, upper, last);
        pile.requireAwake(true, carried);
    }

    @Test
    void withoutRotationOnlyDisplacementCounts() {
        Pile plain = new Pile(new Contacts(), SLEEP);
        int restless = plain.body(BodyType.DYNAMIC);
        int still = plain.body(BodyType.DYNAMIC);
        plain.bodies.piled[restless] = true;
        plain.bodies.piled[still] = true;
        rest(plain, STEPS - 1);
        plain.bodies.y[restless] = 1.01 * DISTANCE;
        plain.bodies.y[still] = DISTANCE;
        rest(plain, 1);

        assertThat(plain.bodies.awake[restless]).isTrue();
        assertThat(plain.bodies.awake[still]).isFalse();
    }
}
