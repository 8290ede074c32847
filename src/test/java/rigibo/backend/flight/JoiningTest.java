package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/**
 * Which flyers join a pile, and when. Discs of radius 1 m lie on a line; a struck disc may get as
 * far as twice its speed takes it in the rest of the step.
 */
class JoiningTest {

    private static final double PLACE = 2e-8;
    private static final double DT = 1.0 / 60;

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
     * Two discs of a pile touch and close at 1 m/s: in ½ s they may get 1 m to either side. Only a
     * search finds a disc at rest at that distance.
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

    /** The flyer would not meet the other bodies of the pile, which are at rest. */
    @Test
    void whatRestsDisturbsNobody() {
        piled(0, 0);
        piled(2, 0);
        int right = disc(4.01, 0);
        air.fly(0.5);

        requireJoined(false, right, 0);
    }

    /**
     * The slower of two bodies in an impact gets the same reach, though nothing else would disturb
     * it.
     */
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
     * A struck wall does not move, so a flyer beside it, but not beside the striking body, flies
     * on.
     */
    @Test
    void whoIsBesideAStruckWallFliesOn() {
        air.add(Air.wall(1, 1));
        piled(0, 1);
        int along = air.add(Air.body(new Circle(1), 1).at(-0.01, 8));
        air.fly(0.5);

        requireJoined(false, along, 0);
    }

    /**
     * A ball that rolls on a floor strikes a crate 6 mm ahead and comes back at once, while a disc
     * falls behind it. The ball's bounces on the floor end first, which is how it joins the pile.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void whatLandedBesideWhatItStrikesDisturbsToo(Preset preset) {
        Pool pool = new Pool(Effects.usual(), preset.accuracy);
        Material elastic = new Material(1, 0.2, 0.8);
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5).material(elastic));
        pool.add(
                BodyDefinition.dynamic(Polygon.box(1, 1))
                        .at(-0.506, 0.5)
                        .material(new Material(10, 0.2, 0.8)));
        pool.step(DT);
        pool.add(
                BodyDefinition.dynamic(new Circle(0.157))
                        .at(0.157, 0.157)
                        .velocity(-1.4, -2e-3)
                        .spin(1.4 / 0.157)
                        .material(elastic));
        RigidBody falls =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.223))
                                .at(0.157 + 0.351, 0.157 + 0.157)
                                .velocity(-0.4, -1.9)
                                .material(new Material(5, 0.2, 0.8)));
        double deepest = 0;
        for (int i = 0; i < 3; i++) {
            deepest = Math.max(deepest, pool.step(DT).deepestOverlap());
        }
        double ofASubstep = 2 * DT / preset.accuracy.substeps();
        assertThat(deepest / falls.shape().smallestWidth()).isLessThan(ofASubstep);
    }

    /** A body reached over 0.3 m hands on the remaining 0.7 m to what touches it. */
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
     * A fast flyer joins because of a slow neighbour half a metre away, and also strikes a third
     * body 5 m ahead. At 20 m/s for ½ s its reach is 20 m from the start of the step. The order of
     * the bodies does not matter.
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
     * After ¼ s the struck body finds a fast flyer that passes at 0.4 m. That one joins and strikes
     * a body 3 m ahead; in the remaining ¼ s its 20 m/s reach 10 m.
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
     * A wall throws back the first of two bodies of a pile at 10 m/s: it gets 1 m at most in 1/20
     * s. It hands all of that to the second, whether that moves along or rests.
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

    /** From ¼ s on the struck body moves at 2 m/s, or twice as fast where it is wedged: 1 m. */
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

    /**
     * A heavy body of a pile hardly moves, but the body that strikes it comes back by 1 m at most.
     */
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

    /** A body too slow to reach any other still joins the pile that it hits. */
    @Test
    void theSlowJoinToo() {
        int slow = disc(0, 1e-5);
        piled(2 + 1e-6, 0);
        int beside = disc(-2 - 1e-3, 1e-5);
        air.fly(0.2);

        requireJoined(true, slow, 0.1);
        requireJoined(false, beside, 0);
    }

    /** The flyer meets two bodies of a pile at once, from between them; it joins at the first. */
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

    /** Manifolds of bodies that joined are measured at their present poses. */
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
     * meanwhile. A body that strikes it after 0.1 s meets it there, at the end of its flight.
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

    /** Nothing of the pile strikes a sleeping body, so it disturbs no other until it wakes. */
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

    /** Where impacts are split within the step, none is predicted, but who is struck is known. */
    @ParameterizedTest
    @CsvSource({"0.99, true", "1.01, false"})
    void whoIsBesideBouncersJoinsWithoutPredictions(double gap, boolean joins) {
        Air split = new Air(Accuracy.DRAFT);
        int left = split.add(Air.disc(0, 0.5, 1));
        int right = split.add(Air.disc(2, -0.5, 1));
        split.pile(left);
        split.pile(right);
        int beside = split.add(Air.disc(4 + gap, -0.5, 1));
        int striker = split.add(Air.disc(50, 9, 1));
        split.add(Air.disc(53, 0, 1));
        split.fly(0.5);

        assertThat(split.bodies.piled[beside]).isEqualTo(joins);
        assertThat(split.bodies.velocityX[striker]).as("m/s, on its way through").isEqualTo(9);
    }

    private int sleeper(double x) {
        int slot = disc(x, 0);
        air.bodies.awake[slot] = false;
        air.storage.data.roster.isStale = true;
        return slot;
    }

    private void requireAwake(boolean isAwake, int slot) {
        assertThat(air.bodies.awake[slot]).as("body %d is awake", slot).isEqualTo(isAwake);
        assertThat(air.bodies.piled[slot]).isEqualTo(isAwake);
    }

    /** Bouncers get 1 m to either side, and their own speeds bring them at most ¼ m nearer. */
    @ParameterizedTest
    @CsvSource({"0.99, true", "1.26, false"})
    void sleepersBesideBouncersWake(double gap, boolean wakes) {
        piled(0, 0.5);
        piled(2, -0.5);
        int right = sleeper(4 + gap);
        int left = sleeper(-2 - gap);
        air.fly(0.5);

        requireAwake(wakes, right);
        requireAwake(wakes, left);
    }

    /**
     * Bouncers get 1 m to either side. The flyer beside them joins at once; it flies 2 m in the
     * step, and 2 m more at most if it is struck.
     */
    @ParameterizedTest
    @CsvSource({"1.9, true", "4.1, false"})
    void whoJoinsWakesTheSleeperAhead(double gap, boolean wakes) {
        piled(0, 0.5);
        piled(2, -0.5);
        int flyer = disc(4.5, 4);
        int sleeper = sleeper(6.5 + gap);
        air.fly(0.5);

        requireJoined(true, flyer, 0);
        requireAwake(wakes, sleeper);
    }

    /**
     * The middle one of three is the first or the second body of its pairs; both impacts are
     * simultaneous.
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
     * A row in which each body reaches the next at the same time is struck at once, and grows as it
     * shrank.
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
            // Left by 300 passes over such a row.
            assertThat(rough.bodies.velocityX[i]).isEqualTo(2 * mean + 0.1 * i, within(0.01));
        }
    }

    /**
     * Simultaneous means a thousandth of the tolerance at 1 m/s; 10⁻⁴ s is a hundred times that.
     */
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

    /** A step leaves nothing behind: the same flight again, with more bodies than at first. */
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
