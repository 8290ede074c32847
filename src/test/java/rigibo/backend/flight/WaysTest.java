package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.Found;

import java.util.Arrays;

/**
 * How far bodies ahead may lead discs on a line off their paths in half a second. All discs are 2 m
 * wide.
 */
class WaysTest {

    private static final double DT = 0.5;

    /** Ways from a hundredth of a millimetre on count, and 2 mm of overlap are kept. */
    private static final double LEAST = 5e-6;

    private static final double KEPT = 1e-3;

    /** Round-off of places of some metres, and that of a dozen sums of them. */
    private static final double ROUND_OFF = 1e-13;

    private final Air air = new Air(Accuracy.EXACT);

    private int disc(double x, double velocityX, double mass) {
        return air.add(
                BodyDefinition.dynamic(new Circle(1)).at(x, 0).velocity(velocityX, 0).mass(mass));
    }

    /** The ways along the contacts of bodies that follow each other. */
    private Ways waysOf(boolean isFirstFirst, int... bodies) {
        air.meet(DT);
        Ways ways = new Ways(air.storage.data, LEAST, KEPT);
        ways.begin();
        for (int i = 0; i < bodies.length - 1; i++) {
            int first = isFirstFirst ? i : bodies.length - 2 - i;
            ways.add(air.pairOf(bodies[first], bodies[first + 1]), DT);
        }
        ways.handOn();
        return ways;
    }

    private static int[] numbers(Found found) {
        return Arrays.copyOf(found.numbers, found.count);
    }

    /** They close at 0.5 m/s over 0.1 m, and would overlap by 0.15 m. */
    @Test
    void ofTwoTheLighterOneIsLedFarther() {
        int a = disc(0, 0.3, 1);
        int b = disc(2.1, -0.2, 3);
        Ways ways = waysOf(true, a, b);

        assertThat(ways.ledTo(a, -1, 0)).isEqualTo(0.15 * 3 / 4, within(ROUND_OFF));
        assertThat(ways.ledTo(b, 1, 0)).isEqualTo(0.15 / 4, within(ROUND_OFF));
        assertThat(ways.ledTo(a, 1, 0)).isZero();
        assertThat(ways.ledTo(a, 0, 1)).isZero();
        assertThat(ways.reach(a)).isEqualTo(0.15 * 3 / 4, within(ROUND_OFF));
    }

    /** A fixed body does not give way: the other one takes all of it. */
    @Test
    void whatIsFixedPushesInFull() {
        int wall = air.add(Air.wall(-1, -1));
        int a = disc(0, -0.2, 7);
        Ways ways = waysOf(true, wall, a);

        assertThat(ways.ledTo(a, 1, 0)).isEqualTo(0.1, within(ROUND_OFF));
        assertThat(numbers(ways.led)).containsExactly(a);
    }

    /** Only the contact with the wall closes, and yet the end of the column is stopped. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void wayGoesAlongAColumnInAnyOrderOfContacts(boolean isWallFirst) {
        int[] bodies = new int[12];
        bodies[0] = air.add(Air.wall(-1, -1));
        for (int i = 1; i < bodies.length; i++) {
            bodies[i] = disc(2 * (i - 1), -0.2, i);
        }
        Ways ways = waysOf(isWallFirst, bodies);

        for (int i = 1; i < bodies.length; i++) {
            assertThat(ways.ledTo(bodies[i], 1, 0)).isEqualTo(0.1, within(ROUND_OFF));
        }
    }

    /** Each disc is faster than the one ahead of it, so the closing distances add up. */
    @Test
    void waysAddUp() {
        int[] bodies = new int[8];
        bodies[0] = air.add(Air.wall(-1, -1));
        double sum = 0;
        for (int i = 1; i < bodies.length; i++) {
            bodies[i] = disc(2 * (i - 1), -0.02 * i, 1);
        }
        Ways ways = waysOf(true, bodies);

        for (int i = 1; i < bodies.length; i++) {
            sum += 0.02 * DT;
            assertThat(ways.ledTo(bodies[i], 1, 0)).isEqualTo(sum, within(ROUND_OFF));
        }
    }

    /** A contact found later hands on the present ways of its bodies. */
    @Test
    void laterContactsTakePart() {
        int wall = air.add(Air.wall(-1, -1));
        int a = disc(0, -0.2, 1);
        int b = disc(2, -0.2, 1);
        Ways ways = waysOf(true, wall, a);
        assertThat(ways.ledTo(b, 1, 0)).isZero();

        ways.add(air.pairOf(a, b), DT);
        ways.handOn();

        assertThat(ways.contacts()).isEqualTo(2);
        assertThat(ways.ledTo(b, 1, 0)).isEqualTo(0.1, within(ROUND_OFF));
    }

    /** Overlap that is kept leads no body off; the rest does. */
    @Test
    void overlapThatIsKeptDoesNotCount() {
        int a = disc(0, 0, 1);
        int b = disc(2 - 0.9 * 2 * KEPT, 0, 1);
        int c = disc(40, 0, 1);
        int d = disc(42 - 0.1 - 2 * KEPT, 0, 1);
        Ways resting = waysOf(true, a, b);
        Ways removed = waysOf(true, c, d);

        assertThat(resting.led.count).isZero();
        assertThat(removed.ledTo(d, 1, 0)).isEqualTo(0.05, within(ROUND_OFF));
    }

    /** Contacts in a moving frame give the same ways as contacts at rest. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.25, -1024})
    void nothingDependsOnTheFrame(double speed) {
        int a = disc(0, speed + 0.5, 1);
        int b = disc(2, speed, 1);
        int c = disc(4, speed - 0.25, 1);
        Ways ways = waysOf(true, a, b, c);

        // The middle one is led by half of its closing distance, the end by two thirds of the sum.
        assertThat(ways.ledTo(c, 1, 0)).isEqualTo((0.125 + 0.125) * 2 / 3, within(ROUND_OFF));
        assertThat(ways.ledTo(a, -1, 0)).isEqualTo((0.25 + 0.0625) * 2 / 3, within(ROUND_OFF));
    }

    /** They close at 0.5 m/s along (0.6, 0.8), with and without turning. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void waysGoAlongTheNormal(boolean turns) {
        Air skew = turns ? air : new Air(Accuracy.EXACT, new Contacts());
        int a = skew.add(BodyDefinition.dynamic(new Circle(1)).velocity(0.3, 0.4).mass(1));
        int b = skew.add(BodyDefinition.dynamic(new Circle(1)).at(1.2, 1.6).mass(3));
        skew.meet(DT);
        Ways ways = new Ways(skew.storage.data, LEAST, KEPT);
        ways.begin();
        ways.add(skew.pairOf(a, b), DT);
        ways.handOn();

        assertThat(ways.ledTo(b, 0.6, 0.8)).isEqualTo(0.25 / 4, within(ROUND_OFF));
        assertThat(ways.ledTo(b, 1, 0)).isEqualTo(0.6 * 0.25 / 4, within(ROUND_OFF));
        assertThat(ways.ledTo(b, 0.8, -0.6)).isEqualTo(0, within(ROUND_OFF));
        assertThat(ways.ledTo(a, -0.6, -0.8)).isEqualTo(0.25 * 3 / 4, within(ROUND_OFF));
        assertThat(ways.reach(b)).isEqualTo(0.25 / 4, within(ROUND_OFF));
    }

    /**
     * A body pushed from both sides has a way in either direction, and a longer one in one of them.
     */
    @Test
    void aBodyHasAWayAndOneAgainstIt() {
        int a = disc(0, 0.2, 1);
        int b = disc(2, 0, 1);
        int c = disc(4, -0.4, 1);
        Ways ways = waysOf(true, a, b, c);

        // By half of its closing distance with a; and by two thirds of that and of b's with c.
        assertThat(ways.ledTo(b, 1, 0)).isEqualTo(0.05, within(ROUND_OFF));
        assertThat(ways.ledTo(b, -1, 0)).isEqualTo(0.1, within(ROUND_OFF));
        assertThat(ways.reach(b)).isEqualTo(0.1, within(ROUND_OFF));
        assertThat(ways.ledTo(c, 1, 0)).isEqualTo((0.05 + 0.2) * 2 / 3, within(ROUND_OFF));
        assertThat(ways.ledTo(a, -1, 0)).isEqualTo((0.1 + 0.1) * 2 / 3, within(ROUND_OFF));
    }

    /** Ways count from 10 µm on, for discs 2 m wide. */
    @ParameterizedTest
    @CsvSource({"0.9, false", "1.1, true"})
    void shortWaysAreLeftOut(double share, boolean isLed) {
        int wall = air.add(Air.wall(-1, -1));
        int a = disc(0, -share * 2 * LEAST / DT, 1);
        Ways ways = waysOf(true, wall, a);

        assertThat(ways.led.count).isEqualTo(isLed ? 1 : 0);
    }

    /** A column with ways is not affected by one without, and no other contact takes part. */
    @Test
    void columnsDoNotMatterToEachOther() {
        int[] bodies = new int[9];
        bodies[0] = air.add(Air.wall(-1, -1));
        for (int i = 1; i < bodies.length; i++) {
            bodies[i] = disc(2 * (i - 1), i % 2 == 0 ? -0.3 : -0.2, i);
        }
        int a = disc(100, 0.5, 1);
        int b = disc(102, 0, 1);
        Ways alone = waysOf(false, bodies);
        double[] led = new double[bodies.length];
        for (int i = 1; i < bodies.length; i++) {
            led[i] = alone.ledTo(bodies[i], 1, 0);
        }
        Ways both = new Ways(air.storage.data, LEAST, KEPT);
        both.begin();
        both.add(air.pairOf(a, b), DT);
        for (int i = bodies.length - 2; i >= 0; i--) {
            both.add(air.pairOf(bodies[i], bodies[i + 1]), DT);
        }
        both.handOn();

        for (int i = 1; i < bodies.length; i++) {
            assertThat(both.ledTo(bodies[i], 1, 0)).isEqualTo(led[i]);
        }
        assertThat(both.ledTo(b, 1, 0)).isEqualTo(0.125, within(ROUND_OFF));
    }

    /** A step starts without the ways of the last one, also with many bodies. */
    @Test
    void everyStepBeginsAnew() {
        int wall = air.add(Air.wall(-1, -1));
        int a = disc(0, -0.2, 1);
        int b = disc(2, -0.2, 1);
        Ways ways = waysOf(true, wall, a, b);
        int[] crowd = new int[50];
        for (int i = 0; i < crowd.length; i++) {
            crowd[i] = disc(100 + 2 * i, i == 0 ? 0.4 : 0, 1);
        }
        air.meet(DT);
        ways.begin();
        assertThat(ways.contacts()).isZero();
        assertThat(ways.led.count).isZero();
        assertThat(ways.reach(a)).isZero();
        for (int i = 0; i < crowd.length - 1; i++) {
            ways.add(air.pairOf(crowd[i], crowd[i + 1]), DT);
        }
        ways.handOn();

        assertThat(ways.reach(b)).isZero();
        // Each disc takes what all behind it push by: of n equal discs the next gets n parts of n +
        // 1.
        double way = 0.2;
        for (int i = 1; i < crowd.length; i++) {
            way *= i / (i + 1.0);
            assertThat(ways.ledTo(crowd[i], 1, 0)).isEqualTo(way, within(ROUND_OFF));
        }
        assertThat(ways.led.count).isEqualTo(crowd.length);
    }

    /** Who leads a sleeper off wakes it: half of ¼ m for one of two equal discs. */
    @Test
    void whatSleepsIsLedAsIfItWereAwake() {
        int a = disc(0, 0.5, 1);
        int b = disc(2, 0, 1);
        air.bodies.awake[b] = false;
        Ways ways = waysOf(true, a, b);

        assertThat(ways.ledTo(b, 1, 0)).isEqualTo(0.125, within(ROUND_OFF));
        assertThat(ways.ledTo(a, -1, 0)).isEqualTo(0.125, within(ROUND_OFF));
    }
}
