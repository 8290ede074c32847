package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/**
 * Who joins a pile, and when: discs of 1 m on a line, of which what is struck may get as far as
 * twice its speed leads in what is left of the step.
 */
class JoiningTest {

    private static final double PLACE = 2e-8;

    private final Air air = new Air(Accuracy.EXACT);

    private int disc(double x, double velocityX) {
        return air.add(Air.disc(x, velocityX, 1));
    }

    private int piled(double x, double velocityX) {
        int slot = disc(x, velocityX);
        air.pile(slot);
        return slot;
    }

    private void requireJoined(boolean joins, int slot, double time) {
        assertThat(air.bodies.piled[slot]).as("body %d is piled", slot).isEqualTo(joins);
        if (joins) {
            assertThat(air.bodies.pileTime[slot]).isEqualTo(time, within(PLACE));
        }
    }

    /**
     * Two of a pile touch and close at 1 m/s: in ½ s they may get 1 m, to either side. So far off
     * at rest a disc is only found by looking round.
     */
    @ParameterizedTest
    @CsvSource({"0.99, true", "1.01, false"})
    void whoIsBesideBouncersJoinsAtTheStart(double gap, boolean joins) {
        piled(0, 0.5);
        piled(2, -0.5);
        int right = disc(4 + gap, -0.5);
        int left = disc(-2 - gap, 0.5);
        air.fly(0.5);

        requireJoined(joins, right, 0);
        requireJoined(joins, left, 0);
    }

    /** They close at 1 m/s over 0.6 m, which takes longer than the step. */
    @Test
    void whatDoesNotStrikeWithinTheStepDisturbsNobody() {
        piled(0, 0.5);
        piled(2.6, -0.5);
        int right = disc(4.7, -0.5);
        air.fly(0.5);

        requireJoined(false, right, 0);
    }

    /** It would not meet the others of the pile, and they are at rest. */
    @Test
    void whatRestsDisturbsNobody() {
        piled(0, 0);
        piled(2, 0);
        int right = disc(4.01, 0);
        air.fly(0.5);

        requireJoined(false, right, 0);
    }

    /** The slower of two that strike gets as far, though nothing else would disturb it. */
    @ParameterizedTest
    @CsvSource({"0.99, true, true", "1.01, false, true", "0.99, true, false", "1.01, false, false"})
    void whoIsStruckAtRestDisturbsToo(double gap, boolean joins, boolean isFirst) {
        int side = isFirst ? 1 : -1;
        int beside = disc(side * (-2 - gap), 0);
        for (int i = 0; i < 2; i++) {
            boolean rests = i == 0 == isFirst;
            piled(rests ? 0 : side * 2, rests ? 0 : -side);
        }
        air.fly(0.5);

        requireJoined(joins, beside, 0);
    }

    /**
     * A wall that is struck gets nowhere: who is beside it, but not beside the striker, flies on.
     */
    @Test
    void whoIsBesideAStruckWallFliesOn() {
        air.add(Air.wall(1, 1));
        piled(0, 1);
        int along = air.add(Air.body(new Circle(1), 1).at(-0.01, 8));
        air.fly(0.5);

        requireJoined(false, along, 0);
    }

    /** One that is reached over 0.3 m pushes on by the 0.7 m that are left, and what touches. */
    @ParameterizedTest
    @CsvSource({"0.70, true", "0.71, false"})
    void whoIsReachedPushesOnByWhatIsLeft(double gap, boolean joins) {
        for (int i = 0; i < 40; i++) {
            air.add(Air.disc(3 * i, 0, 1).at(3 * i, 50));
        }
        piled(0, 0.5);
        piled(2, -0.5);
        int reached = disc(4.3, -0.5);
        int next = disc(6.3 + gap, -0.5);
        air.fly(0.5);

        requireJoined(true, reached, 0);
        requireJoined(joins, next, 0);
    }

    /**
     * A fast one joins for a slow neighbour's sake, half a metre on, and strikes a third 5 m ahead
     * all the same: at 20 m/s for ½ s that reaches 20 m, from the start of the step on. Whoever of
     * them is listed first.
     */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void whatAFastOneStrikesThatJoinedReachesFarther(boolean isFirst) {
        int fast = isFirst ? disc(4.5, 20) : -1;
        if (isFirst) {
            piled(11.5, 0);
        }
        piled(0, 1);
        piled(2, 0);
        if (!isFirst) {
            fast = disc(4.5, 20);
            piled(11.5, 0);
        }
        int beyond = disc(13.5 + 15, 0);
        int farBeyond = disc(13.5 + 25, 0);
        air.fly(0.5);

        requireJoined(true, fast, 0);
        requireJoined(true, beyond, 0);
        requireJoined(false, farBeyond, 0);
    }

    /**
     * After ¼ s the struck one finds a fast one that flies past, 0.4 m off: it joins, and strikes
     * one 3 m ahead. In the ¼ s that is left 20 m/s reach 10 m.
     */
    @ParameterizedTest
    @CsvSource({"9, true", "11, false"})
    void whatAFastOneStrikesThatJoinedLaterReachesThen(double gap, boolean joins) {
        disc(0, 2);
        piled(2.5, 0);
        int fast = air.add(Air.body(new Circle(1), 1).at(4.9, -5).velocity(0, 20));
        air.pile(air.add(Air.body(new Circle(1), 1).at(4.9, 5)));
        int beyond = air.add(Air.body(new Circle(1), 1).at(4.9, 7 + gap));
        air.fly(0.5);

        requireJoined(true, fast, 0.25);
        requireJoined(joins, beyond, 0.25);
    }

    /**
     * The first of two of a pile is thrown back by a wall at 10 m/s: it gets 1 m at most in 1/20 s,
     * and hands all of that on to its like, whether that comes along or rests.
     */
    @ParameterizedTest(name = "at {0} m/s with a gap of {1} m: {2}")
    @CsvSource({"10, 0.3, true", "0, 0.3, true", "0, 0.99, true", "0, 1.01, false"})
    void whoIsBehindIsDisturbedToo(double speed, double gap, boolean joins) {
        air.add(Air.wall(1, 1));
        piled(0, 10);
        int second = piled(-2, speed);
        int behind = disc(-4 - gap, speed);
        air.fly(0.05);

        assertThat(air.bodies.pileTime[second]).isZero();
        requireJoined(joins, behind, 0);
    }

    /** From ¼ s on the struck one goes 2 m/s, and twice as fast at most where it is wedged: 1 m. */
    @ParameterizedTest
    @CsvSource({"0.99, true", "1.01, false"})
    void whoIsBesideTheStruckJoinsWhereItIsByThen(double gap, boolean joins) {
        int flyer = disc(0, 2);
        int struck = piled(2.5, 0);
        int beside = disc(4.5 + gap, 0);
        air.bodies.accelerationX[beside] = 0;
        air.bodies.spin[beside] = 4;
        air.fly(0.5);

        requireJoined(true, flyer, 0.25);
        requireJoined(joins, beside, 0.25);
        assertThat(air.bodies.angle[beside]).isEqualTo(joins ? 1 : 2, within(4 * PLACE));
        if (joins) {
            int pair = air.pairOf(struck, beside);
            assertThat(air.pairs.separation[2 * pair]).isEqualTo(gap, within(PLACE));
        }
    }

    /** A heavy one in a pile hardly moves, but what strikes it comes back: 1 m at most. */
    @ParameterizedTest
    @CsvSource({"0.99, true", "1.01, false"})
    void whoIsBehindTheStrikerJoinsToo(double gap, boolean joins) {
        int flyer = disc(0, 2);
        int heavy =
                air.add(
                        BodyDefinition.dynamic(new Circle(1))
                                .mass(1e6)
                                .at(2.5, 0)
                                .material(new Material(1, 0, 1)));
        air.pile(heavy);
        int behind = disc(-2 - gap, 2);
        air.fly(0.5);

        requireJoined(true, flyer, 0.25);
        requireJoined(joins, behind, 0.25);
    }

    /** What is so slow that it could reach nobody joins all the same what it hits. */
    @Test
    void theSlowJoinToo() {
        int slow = disc(0, 1e-5);
        piled(2 + 1e-6, 0);
        int beside = disc(-2 - 1e-3, 1e-5);
        air.fly(0.2);

        requireJoined(true, slow, 0.1);
        requireJoined(false, beside, 0);
    }

    /** It meets two of a pile at once, from between: by the first of them it has joined. */
    @Test
    void whoMeetsTwoAtOnceJoinsOnce() {
        int flyer = disc(0, 2);
        for (int side = -1; side <= 1; side += 2) {
            air.pile(air.add(Air.body(new Circle(1), 1).at(1 + 1.6, 1.2 * side)));
        }
        air.fly(1);

        requireJoined(true, flyer, 0.5);
        int first = air.pairs.impacts[air.pairOf(flyer, 1)];
        assertThat(first + air.pairs.impacts[air.pairOf(flyer, 2)]).isEqualTo(1);
    }

    /** The manifolds of what joined are of where both are by then. */
    @Test
    void contactsOfTheJoinedAreMeasuredAnew() {
        int flyer = disc(0, 2);
        piled(3, 0);
        int other = air.add(Air.body(new Circle(1), 1).at(1, 2.1).velocity(0, -0.1));
        air.pile(other);
        air.fly(1);

        requireJoined(true, flyer, 0.5);
        int pair = air.pairOf(flyer, other);
        assertThat(air.pairs.points[pair]).isEqualTo(1);
        assertThat(air.pairs.separation[2 * pair]).isEqualTo(0.05, within(PLACE));
        assertThat(air.pairs.pointX[2 * pair]).isEqualTo(1, within(PLACE));
    }

    /**
     * On the floor at 1 m/s with e = ½ and g = 10 its bounces take 0.2 s, and it slides on
     * meanwhile. What strikes it after 0.1 s finds it where it is by then, at the end of its
     * flight.
     */
    @Test
    void whatIsStruckBeforeItsBouncesEndRestsThen() {
        air.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        int lander = air.add(Air.body(new Circle(1), 0.5).at(0, 1).velocity(1, -1));
        air.pull(0, -10);
        int flyer = air.add(Air.body(new Circle(1), 0.5).at(2 + 1, 1).velocity(-9, 0));
        air.fly(0.5);

        requireJoined(true, flyer, 0.1);
        requireJoined(true, lander, 0.1);
        assertThat(air.bodies.x[lander]).isEqualTo(0.1, within(1e-6));
    }

    /** A sleeper is struck by nothing of the pile: it disturbs nobody until it wakes. */
    @Test
    void sleepersDisturbNobody() {
        int sleeper = disc(0, 0);
        air.bodies.awake[sleeper] = false;
        air.storage.data.roster.isStale = true;
        piled(2, 0.5);
        int beside = disc(-2.01, 0);
        air.fly(0.5);

        assertThat(air.bodies.awake[sleeper]).isFalse();
        requireJoined(false, beside, 0);
    }

    /**
     * The middle of three is the first of its pairs, or the second: struck at once all the same.
     */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void tiesAreFoundByEitherBody(int middle) {
        for (int slot = 0, side = -1; slot < 3; slot++) {
            if (slot == middle) {
                disc(0, 0);
            } else {
                disc(3 * side, -2 * side);
                side = 1;
            }
        }
        air.fly(1);

        assertThat(air.storage.data.counters.impacts).isEqualTo(2);
        assertThat(air.bodies.velocityX[middle]).isEqualTo(0, within(1e-12));
    }

    /**
     * A row in which each comes up to the next at once is struck at once, and grows as it shrank.
     */
    @Test
    void aRowThatShrinksGrowsAgain() {
        Air rough = new Air(Accuracy.EXACT.withImpactTolerance(1e-3));
        for (int i = 0; i < 20; i++) {
            rough.add(Air.disc(2.01 * i, -0.1 * i, 1));
        }
        rough.fly(0.15);

        assertThat(rough.storage.data.counters.impacts).isEqualTo(19);
        for (int i = 0; i < 20; i++) {
            double mean = -0.1 * 9.5;
            // What 300 passes over such a row leave.
            assertThat(rough.bodies.velocityX[i]).isEqualTo(2 * mean + 0.1 * i, within(0.01));
        }
    }

    /** A tie is a thousandth of the tolerance at 1 m/s, and 10⁻⁴ s is a hundred of them. */
    @Test
    void whatIsAHundredTiesApartIsStruckOneByOne() {
        Air rough = new Air(Accuracy.EXACT.withImpactTolerance(1e-3));
        rough.add(Air.disc(0, 0, 1));
        rough.add(Air.disc(3, -2, 1));
        rough.add(Air.disc(-3 - 2e-4, 2, 1));
        rough.fly(1);

        assertThat(rough.storage.data.counters.impacts).isEqualTo(3);
        assertThat(rough.bodies.velocityX).startsWith(new double[] {0, 2, -2}, within(1e-12));
    }

    /** Each step is by itself: the same flight, with more bodies than at first. */
    @Test
    void aStepLeavesNothingToTheNext() {
        int first = disc(0, 2);
        int second = disc(3, 0);
        air.fly(0.25);
        int[] more = new int[40];
        for (int i = 0; i < more.length; i++) {
            more[i] = air.add(Air.disc(3 * i, i % 2 == 0 ? 4 : 0, 1).at(3 * i, 9));
        }
        air.fly(0.375);

        assertThat(air.bodies.x[first]).isEqualTo(1, within(PLACE));
        assertThat(air.bodies.x[second]).isEqualTo(3 + 2 * 0.125, within(PLACE));
        for (int i = 0; i < more.length; i += 2) {
            assertThat(air.bodies.x[more[i]]).isEqualTo(3 * i + 1, within(PLACE));
            assertThat(air.bodies.x[more[i + 1]]).isEqualTo(3 * i + 3.5, within(PLACE));
        }
    }
}
