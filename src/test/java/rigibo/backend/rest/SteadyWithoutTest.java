package rigibo.backend.rest;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Waking;

/**
 * Who sleeps on when a body goes, by statics: a body whose weight and loads all lie above the span
 * of its supports cannot tip, and what loses a load from above only presses less.
 *
 * <p>A beam from −1 to 1 m on a pillar, with a weight on it that goes.
 */
class SteadyWithoutTest {

    private static final double G = 8;

    private final Pile pile =
            new Pile(new Gravity(0, -G), new Contacts(), new Rotation(), new Sleep());
    private final Bodies bodies = pile.bodies;
    private final Pairs pairs = pile.pairs;

    private final int weight = sleeper();
    private final int beam = sleeper();
    private final int pillar = sleeper();
    private final int ground = pile.body(BodyType.STATIC);

    private int sleeper() {
        int slot = pile.body(BodyType.DYNAMIC);
        bodies.awake[slot] = false;
        bodies.accelerationY[slot] = -G;
        return slot;
    }

    /** Lets a body touch another, with the normal (x, y) from the first to the second. */
    private int touch(int from, int to, double x, double y) {
        int pair = pile.contact(from, to, 2);
        double sign = from < to ? 1 : -1;
        pairs.normalX[pair] = sign * x;
        pairs.normalY[pair] = sign * y;
        pairs.touching[pair] = true;
        return pair;
    }

    /** Lets a body stand on another from one place to another, m. */
    private int stand(int upper, int lower, double left, double right) {
        int pair = touch(lower, upper, 0, 1);
        pairs.pointX[2 * pair] = left;
        pairs.pointX[2 * pair + 1] = right;
        return pair;
    }

    private void take(int going) {
        new SupportLoss(pile.data, new Waking(pile.data)).wakeNeighbours(going);
    }

    /** The weight presses on a point: as it still lies there, it counts as a load. */
    private void build(double left, double right) {
        stand(weight, beam, 0, 0);
        stand(beam, pillar, left, right);
        stand(pillar, ground, -1, 1);
    }

    /** Its centre of mass is at 0; half a millimetre beside the span would not be seen. */
    @ParameterizedTest(name = "on a pillar from {0} to {1} m: wakes is {2}")
    @CsvSource({
        "-0.5, 0.5, false",
        "0, 0.5, false",
        "-0.5, 0, false",
        "0.0004, 0.5, false",
        "-0.5, -0.0004, false",
        "0.0005, 0.5, false",
        "-0.5, -0.0005, false",
        "0.0006, 0.5, true",
        "-0.5, -0.0006, true"
    })
    void aBeamStandsOnWhatIsUnderItsCentre(double left, double right, boolean wakes) {
        build(left, right);
        take(weight);
        pile.requireAwake(wakes, beam, pillar);
    }

    /** The tolerance scales with the smallest width. */
    @ParameterizedTest
    @CsvSource({"2, false", "0.5, true"})
    void theSlackScalesWithTheBeam(double width, boolean wakes) {
        bodies.smallestWidth[beam] = width;
        build(0.0006, 0.5);
        take(weight);
        pile.requireAwake(wakes, beam);
    }

    /** A load beyond the pillar that the weight held in balance: it tips to either side. */
    @ParameterizedTest(name = "with a load from {0} to {1} m: wakes is {2}")
    @CsvSource({
        "-0.4, 0.4, false",
        "0.4, 0.6, true",
        "-0.6, -0.4, true",
        "-0.6, 0.6, true",
        "-0.5, 0.5, false"
    })
    void aBeamStandsIfItsLoadsAreAboveItsSupports(double left, double right, boolean wakes) {
        int load = sleeper();
        build(-0.5, 0.5);
        stand(load, beam, left, right);
        take(weight);
        pile.requireAwake(wakes, load, beam, pillar);
    }

    /** Two pillars span what is between them. */
    @Test
    void supportsSpanTogether() {
        int other = sleeper();
        build(-0.9, -0.8);
        stand(beam, other, 0.8, 0.9);
        stand(other, ground, -1, 1);
        take(weight);
        pile.requireAwake(false, beam, pillar, other);
    }

    /** Places are the world's: all of it 3 m to the right, and the beam where it was. */
    @ParameterizedTest
    @CsvSource({"3, false", "2.5, false", "3.5, false", "1.5, true", "4.5, true", "0, true"})
    void theCentreOfMassIsAboveTheSupportsInTheWorld(double x, boolean wakes) {
        bodies.x[beam] = x;
        bodies.x[pillar] = 3;
        stand(weight, beam, 2.9, 3.1);
        stand(beam, pillar, 2.5, 3.5);
        stand(pillar, ground, 2, 4);
        take(weight);
        pile.requireAwake(wakes, beam);
    }

    /** What the beam stands on must be as steady: its own centre is not above its own foot. */
    @Test
    void aSupportThatWouldTipIsNone() {
        stand(weight, beam, -0.1, 0.1);
        stand(beam, pillar, -0.5, 0.5);
        stand(pillar, ground, 0.1, 1);
        take(weight);
        pile.requireAwake(true, beam, pillar);
    }

    /** Whichever contact was first. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void whatIsHeldFromTheSideWakes(boolean isFirst) {
        if (isFirst) {
            touch(beam, sleeper(), 1, 0);
        }
        build(-0.5, 0.5);
        if (!isFirst) {
            touch(beam, sleeper(), 1, 0);
        }
        take(weight);
        pile.requireAwake(true, beam);
    }

    /** On a slope it is friction that holds; of cosines above 0.999 nothing is to be seen. */
    @ParameterizedTest
    @CsvSource({"0.1, true", "-0.1, true", "0.02, false", "-0.02, false"})
    void whatStandsAslantWakes(double angle, boolean wakes) {
        stand(weight, beam, -0.1, 0.1);
        int pair = touch(ground, beam, Math.sin(angle), Math.cos(angle));
        pairs.pointX[2 * pair] = -0.5;
        pairs.pointX[2 * pair + 1] = 0.5;
        take(weight);
        pile.requireAwake(wakes, beam);
    }

    /** A weight that leans from aslant was no load from above. */
    @Test
    void whatWasHeldByTheOneThatGoesWakes() {
        stand(beam, ground, -0.5, 0.5);
        touch(beam, weight, 1, 0);
        take(weight);
        pile.requireAwake(true, beam);
    }

    /** Upright or all but, and what it stood on itself sleeps on: it only lost a load. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.02, -0.02})
    void whatStandsOnTheOneThatGoesWakes(double angle) {
        stand(weight, beam, 0, 0);
        int pair = touch(pillar, beam, Math.sin(angle), Math.cos(angle));
        pairs.pointX[2 * pair] = -0.5;
        pairs.pointX[2 * pair + 1] = 0.5;
        int base = sleeper();
        stand(pillar, base, -0.5, 0.5);
        stand(base, ground, -1, 1);
        take(pillar);
        pile.requireAwake(true, beam, weight);
        pile.requireAwake(false, base);
    }

    /**
     * Two beams under one weight: the one would tip, the other would not, whoever is asked first.
     */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void eachOfTwoNeighboursIsAskedByItself(boolean tipsFirst) {
        int other = sleeper();
        double left = tipsFirst ? 0.1 : -0.5;
        stand(weight, beam, 0, 0);
        stand(weight, other, 0, 0);
        stand(beam, ground, left, 0.5);
        stand(other, ground, -0.4 - left, 0.5);
        take(weight);
        pile.requireAwake(tipsFirst, beam);
        pile.requireAwake(!tipsFirst, other);
    }

    /** On a belt that runs friction pulls; on one that stands nothing does. */
    @ParameterizedTest
    @CsvSource({"1, true", "0, false"})
    void whatStandsOnSomethingDrivenWakes(double speed, boolean wakes) {
        int belt = pile.body(BodyType.KINEMATIC);
        bodies.velocityX[belt] = speed;
        stand(weight, beam, -0.1, 0.1);
        stand(beam, belt, -0.5, 0.5);
        take(weight);
        pile.requireAwake(wakes, beam);
    }

    @Test
    void whatStandsOnSomethingAwakeWakes() {
        build(-0.5, 0.5);
        bodies.awake[pillar] = true;
        take(weight);
        pile.requireAwake(true, beam);
    }

    /** Relieved of its load, a support that is pulled upwards would rise. */
    @Test
    void aSupportPulledUpwardsIsNone() {
        build(-0.5, 0.5);
        bodies.accelerationY[pillar] = 1;
        take(weight);
        pile.requireAwake(true, beam);
    }

    @Test
    void whatHasNoWeightWakes() {
        build(-0.5, 0.5);
        bodies.accelerationY[beam] = 0;
        take(weight);
        pile.requireAwake(true, beam);
    }

    @Test
    void whatOnlyComesNearIsNoNeighbour() {
        stand(beam, ground, -0.5, 0.5);
        int apart = sleeper();
        pairs.touching[stand(apart, weight, -0.5, 0.5)] = false;
        pairs.touching[touch(beam, apart, 1, 0)] = false;
        stand(weight, beam, -0.1, 0.1);
        take(weight);
        pile.requireAwake(false, beam, apart);
    }

    /** Nor is a body a support that is near a beam without touching it. */
    @Test
    void whatOnlyComesNearCarriesNothing() {
        build(0.2, 0.5);
        pairs.touching[stand(beam, sleeper(), -0.5, -0.2)] = false;
        take(weight);
        pile.requireAwake(true, beam);
    }

    /** What it does without its neighbour has to be seen before it may sleep. */
    @Test
    void theStillnessOfWhatIsAwakeStartsAnew() {
        build(-0.5, 0.5);
        int apart = sleeper();
        for (int slot : new int[] {beam, apart}) {
            bodies.awake[slot] = true;
            bodies.stillTime[slot] = 0.4;
        }
        take(weight);
        assertThat(bodies.stillTime[beam]).isZero();
        assertThat(bodies.stillTime[apart]).isEqualTo(0.4);
    }

    /** A quarter turn of everything, gravity too: down is where the acceleration points. */
    @ParameterizedTest
    @CsvSource({"-0.5, 0.5, false", "0.1, 0.5, true", "-0.5, -0.1, true"})
    void downIsWhereverGravityPoints(double low, double high, boolean wakes) {
        for (int slot : new int[] {weight, beam, pillar}) {
            bodies.accelerationX[slot] = G;
            bodies.accelerationY[slot] = 0;
            bodies.x[slot] = 7;
        }
        lean(weight, beam, -0.1, 0.1);
        lean(beam, pillar, low, high);
        lean(pillar, ground, -1, 1);
        take(weight);
        pile.requireAwake(wakes, beam);
    }

    /** Beams on pillars in a world that is turned: statics knows no axes. */
    @ParameterizedTest(name = "turned by {0}, on a pillar from {1} to {2} m: wakes is {3}")
    @CsvSource({
        "0.7, -0.5, 0.5, false",
        "0.7, 0.0004, 0.5, false",
        "0.7, 0.0006, 0.5, true",
        "0.7, -0.5, -0.0004, false",
        "0.7, -0.5, -0.0006, true",
        "-2, 0.0004, 0.5, false",
        "-2, -0.5, -0.0006, true",
        "2.5, -0.5, -0.0004, false",
        "2.5, 0.0006, 0.5, true"
    })
    void theWorldMayBeTurned(double angle, double left, double right, boolean wakes) {
        build(left, right);
        for (int slot : new int[] {weight, beam, pillar}) {
            bodies.accelerationX[slot] = G * Math.sin(angle);
            bodies.accelerationY[slot] = -G * Math.cos(angle);
            bodies.x[slot] = -7 * Math.sin(angle);
            bodies.y[slot] = 7 * Math.cos(angle);
        }
        for (int i = 0; i < pairs.activeCount; i++) {
            turn(pairs.active[i], angle);
        }
        take(weight);
        pile.requireAwake(wakes, beam);
    }

    /** Points at a height that nothing depends on. */
    private void turn(int pair, double angle) {
        pairs.normalX[pair] = -pairs.normalY[pair] * Math.sin(angle);
        pairs.normalY[pair] *= Math.cos(angle);
        for (int point = 2 * pair; point < 2 * pair + 2; point++) {
            double along = pairs.pointX[point];
            pairs.pointX[point] = along * Math.cos(angle) - 5 * Math.sin(angle);
            pairs.pointY[point] = along * Math.sin(angle) + 5 * Math.cos(angle);
        }
    }

    /** Stands on it with gravity to the right. */
    private void lean(int upper, int lower, double low, double high) {
        int pair = touch(lower, upper, -1, 0);
        pairs.pointY[2 * pair] = low;
        pairs.pointY[2 * pair + 1] = high;
        pairs.pointX[2 * pair] = 7;
        pairs.pointX[2 * pair + 1] = 8;
    }

    /** Each loss asks anew: who was steady before it need not be after. */
    @Test
    void everyLossIsLookedAtByItself() {
        int second = sleeper();
        build(-0.5, 0.5);
        stand(second, beam, -0.1, 0.1);
        SupportLoss loss = new SupportLoss(pile.data, new Waking(pile.data));
        loss.wakeNeighbours(weight);
        pile.requireAwake(false, beam, pillar);
        bodies.x[beam] = 0.6;
        loss.wakeNeighbours(second);
        pile.requireAwake(true, beam, pillar);
    }

    @Test
    void theGroundIsNobodyToWake() {
        stand(weight, ground, -0.5, 0.5);
        take(weight);
        pile.requireAwake(false, ground);
    }
}
