package rigibo.backend.rest;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

/**
 * Rest or flight of a body over a floor, by the rule of the decision: near, pressed, and parting no
 * faster than lifts it by half a millimetre per metre of its width, √(2·g·d).
 */
class PileClassifierTest {

    private static final double G = 8;
    private static final double DT = 1.0 / 64;
    private static final double TOLERANCE = 1e-4;
    private static final Accuracy GAME = Accuracy.GAME.withImpactTolerance(TOLERANCE);

    /** m/s: what rises by half a millimetre against 8 m/s². */
    private static final double LIFT_OFF = Math.sqrt(2 * G * 0.5e-3);

    /** m, up to which two bodies touch. */
    private static final double NEAR = 1e-3;

    private final Pile pile = new Pile(new Gravity(0, -G), new Contacts(), new Rotation());
    private final Bodies bodies = pile.bodies;
    private final Pairs pairs = pile.pairs;

    private final int floor = pile.body(BodyType.STATIC);
    private final int box = falling(pile);
    private final int far = contactsFarFrom(pile.body(BodyType.STATIC), 3);
    private final int contact = pile.contact(floor, box, 2);

    PileClassifierTest() {
        pairs.pointX[2 * contact] = -0.5;
        pairs.pointX[2 * contact + 1] = 0.5;
    }

    /** So many pairs without points, whose numbers come first. */
    private int contactsFarFrom(int body, int count) {
        for (int i = 0; i < count; i++) {
            pile.contact(pile.body(BodyType.STATIC), body, 0);
        }
        return body;
    }

    private static int falling(Pile pile) {
        int slot = pile.body(BodyType.DYNAMIC);
        pile.bodies.accelerationY[slot] = -G;
        pile.bodies.inverseMass[slot] = 1;
        return slot;
    }

    private boolean isPiled(ImpactMode mode) {
        bodies.piled[box] = false;
        pile.accept();
        new PileClassifier(pile.data, GAME, mode).classify(DT);
        assertThat(pairs.resting[contact]).isEqualTo(bodies.piled[box]);
        return bodies.piled[box];
    }

    private boolean isPiled() {
        return isPiled(ImpactMode.EVENTS);
    }

    private void gap(double metres) {
        pairs.separation[2 * contact] = metres;
        pairs.separation[2 * contact + 1] = metres;
    }

    @Test
    void whatLiesStillOnTheFloorRests() {
        assertThat(isPiled()).isTrue();
        assertThat(bodies.piled[floor]).as("the floor is no member of a pile").isFalse();
    }

    /** A first touch within the tolerance of impacts, at a millionth of a second's fall at most. */
    @ParameterizedTest(name = "{0} m over the floor at {1} m/s: rests is {2}")
    @CsvSource({
        "0.0001, 0, true",
        "0.000101, 0, false",
        "-0.0009, 0, true",
        "0, 7.9e-6, true",
        "0, -7.9e-6, true",
        "0, 8e-6, true",
        "0, -8e-6, true",
        "0, 8.1e-6, false",
        "0, -8.1e-6, false"
    })
    void restBeginsOnlyByLyingStill(double height, double speed, boolean rests) {
        gap(height);
        bodies.velocityY[box] = speed;
        assertThat(isPiled()).isEqualTo(rests);
    }

    /**
     * What falls beside a wall rests on nothing, though its face may be upright only up to
     * round-off; on a face that carries a billionth of its weight it does.
     */
    @ParameterizedTest(name = "at a slope of {0}: rests is {1}")
    @CsvSource({"1e-16, false", "-1e-16, false", "1e-13, false", "1e-9, true", "-1e-9, false"})
    void roundOffOfANormalPressesNothing(double slope, boolean rests) {
        pairs.normalX[contact] = 1;
        pairs.normalY[contact] = slope;
        assertThat(isPiled()).isEqualTo(rests);
    }

    /** Once at rest it may move as long as nobody would see it lift. */
    @ParameterizedTest(name = "{0} m over the floor at {1} of the speed: rests is {2}")
    @CsvSource({
        "0, 0.999, true",
        "0, 1.001, false",
        "0.001, 0.999, true",
        "0.00101, 0, false",
        "0, -100, true"
    })
    void restEndsWhereLiftingIsSeen(double height, double share, boolean rests) {
        pairs.resting[contact] = true;
        gap(height);
        bodies.velocityY[box] = share * LIFT_OFF;
        assertThat(isPiled()).isEqualTo(rests);
    }

    /** At four times the width four times the gap, and twice the speed: √d. */
    @Test
    void theRuleScalesWithTheBody() {
        bodies.smallestWidth[box] = 4;
        pairs.resting[contact] = true;
        gap(3.99 * NEAR);
        bodies.velocityY[box] = 1.99 * LIFT_OFF;
        assertThat(isPiled()).isTrue();
        bodies.velocityY[box] = 2.01 * LIFT_OFF;
        assertThat(isPiled()).isFalse();
        pairs.resting[contact] = true;
        bodies.velocityY[box] = 0;
        gap(4.01 * NEAR);
        assertThat(isPiled()).isFalse();
        gap(3.99 * TOLERANCE);
        assertThat(isPiled()).isTrue();
    }

    /** So do the gap that touches and the overlap that is deep, without a queue and with it. */
    @Test
    void touchingScalesWithTheBody() {
        bodies.smallestWidth[box] = 4;
        bodies.velocityY[box] = 5;
        gap(3.99 * NEAR);
        assertThat(isPiled(ImpactMode.DISCRETE)).isTrue();
        gap(4.01 * NEAR);
        assertThat(isPiled(ImpactMode.DISCRETE)).isFalse();
        gap(-3.99 * NEAR);
        assertThat(isPiled()).isFalse();
        gap(-4.01 * NEAR);
        assertThat(isPiled()).isTrue();
    }

    /** However little presses: 2⁻⁷ m/s² lift by a 32nd of the speed that 8 m/s² do. */
    @Test
    void theRuleScalesWithWhatPresses() {
        bodies.accelerationY[box] = -G / 1024;
        assertThat(isPiled()).as("begins").isTrue();
        bodies.velocityY[box] = 0.99 * LIFT_OFF / 32;
        assertThat(isPiled()).as("stays").isTrue();
        bodies.velocityY[box] = 1.01 * LIFT_OFF / 32;
        assertThat(isPiled()).as("ends").isFalse();
    }

    /** What is deeper than it would ever rest is pushed out, whatever it does. */
    @Test
    void deepOverlapIsOfThePile() {
        bodies.velocityY[box] = 5;
        gap(-NEAR);
        assertThat(isPiled()).isFalse();
        gap(-1.01 * NEAR);
        assertThat(isPiled()).isTrue();
    }

    /** Nothing presses: it neither begins to rest nor stays, unless a force held it last. */
    @Test
    void whatNothingPressesFloats() {
        bodies.accelerationY[box] = 0;
        assertThat(isPiled()).isFalse();
        pairs.resting[contact] = true;
        assertThat(isPiled()).isFalse();
        pairs.resting[contact] = true;
        pairs.normalForce[2 * contact] = 1e-3;
        assertThat(isPiled()).isTrue();
        bodies.velocityY[box] = 1e-9;
        assertThat(isPiled()).as("lifted by nothing, it rises for good").isFalse();
    }

    /** A force that lasts presses, but for one that is round-off of the weight of 8 N. */
    @ParameterizedTest(name = "{0} N: rests is {1}")
    @CsvSource({"1e-9, true", "1e-13, false", "1e-320, false"})
    void roundOffOfAForcePressesNothing(double force, boolean rests) {
        pairs.normalX[contact] = 1;
        pairs.normalY[contact] = 0;
        pairs.resting[contact] = true;
        pairs.normalForce[2 * contact] = force;
        assertThat(isPiled()).isEqualTo(rests);
    }

    @Test
    void whatIsPulledAwayFloats() {
        bodies.accelerationY[box] = G;
        assertThat(isPiled()).isFalse();
        pairs.resting[contact] = true;
        assertThat(isPiled()).isFalse();
    }

    @Test
    void withoutPointsNothingRests() {
        pairs.points[contact] = 0;
        for (ImpactMode mode : ImpactMode.values()) {
            assertThat(isPiled(mode)).as("%s", mode).isFalse();
        }
    }

    /** The nearer of two points counts. */
    @Test
    void oneCornerIsEnough() {
        pairs.separation[2 * contact] = 1;
        assertThat(isPiled()).isTrue();
        pairs.separation[2 * contact] = 0;
        pairs.separation[2 * contact + 1] = 1;
        assertThat(isPiled()).isTrue();
    }

    /** Points at half a metre: a spin of ω parts one of them at ω/2, whichever way it turns. */
    @ParameterizedTest
    @ValueSource(doubles = {1, -1})
    void thePointThatPartsFastestCounts(double side) {
        pairs.resting[contact] = true;
        bodies.spin[box] = side * 2 * 1.01 * LIFT_OFF;
        assertThat(isPiled()).isFalse();
        pairs.resting[contact] = true;
        bodies.spin[box] = side * 2 * 0.99 * LIFT_OFF;
        assertThat(isPiled()).isTrue();
    }

    /** A pair of one point has no second one to ask. */
    @Test
    void onlyPointsThatAreThereCount() {
        pairs.points[contact] = 1;
        pairs.resting[contact] = true;
        bodies.spin[box] = 20 * LIFT_OFF;
        assertThat(isPiled()).as("the left corner closes").isTrue();
    }

    @Test
    void withoutRotationThePartingIsOfTheCentres() {
        Pile plain = new Pile(new Gravity(0, -G), new Contacts());
        int lower = plain.body(BodyType.STATIC);
        int upper = falling(plain);
        int pair = plain.contact(lower, upper, 2);
        PileClassifier classifier = new PileClassifier(plain.data, GAME, ImpactMode.EVENTS);
        plain.pairs.normalX[pair] = 0.6;
        plain.pairs.normalY[pair] = 0.8;
        plain.pairs.resting[pair] = true;
        // Pressed by 0.8·g along the normal; along the face nothing parts. Both move on together.
        double liftOff = Math.sqrt(0.8) * LIFT_OFF;
        plain.bodies.velocityX[lower] = 2;
        plain.bodies.velocityY[lower] = 1;
        plain.bodies.velocityX[upper] = 2 - 8 + 0.6 * 0.99 * liftOff;
        plain.bodies.velocityY[upper] = 1 + 6 + 0.8 * 0.99 * liftOff;
        classifier.classify(DT);
        assertThat(plain.pairs.resting[pair]).isTrue();
        plain.bodies.velocityX[upper] = 2 - 8 + 0.6 * 1.01 * liftOff;
        plain.bodies.velocityY[upper] = 1 + 6 + 0.8 * 1.01 * liftOff;
        classifier.classify(DT);
        assertThat(plain.pairs.resting[pair]).isFalse();
    }

    /** Speeds of both count: what rises together does not part. */
    @Test
    void partingIsOfOneFromTheOther() {
        int lift = pile.body(BodyType.KINEMATIC);
        int carried = falling(pile);
        int pair = pile.contact(lift, carried, 1);
        bodies.velocityY[lift] = 3;
        bodies.velocityY[carried] = 3;
        isPiled();
        assertThat(bodies.piled[carried]).isTrue();
        assertThat(pairs.resting[pair]).isTrue();
        assertThat(bodies.piled[lift]).isFalse();
    }

    /** Whoever is above: the normal points up from the one, down from the other. */
    @Test
    void bothBodiesOfARestingPairArePiled() {
        int lower = falling(pile);
        int upper = falling(pile);
        pile.contact(lower, upper, 1);
        isPiled();
        assertThat(bodies.piled[lower]).isTrue();
        assertThat(bodies.piled[upper]).isTrue();
    }

    /** Without a queue of impacts whatever touches is of the pile, or whatever may touch. */
    @ParameterizedTest(name = "{0} at {1} m: {2}")
    @CsvSource({
        "DISCRETE, 0.001, true", "DISCRETE, 0.00101, false",
        "SPLIT, 0.00101, true", "SPLIT, 5, true",
        "EVENTS, 0.00099, false"
    })
    void whatTheModeLeavesToThePile(ImpactMode mode, double height, boolean rests) {
        gap(height);
        bodies.velocityY[box] = -3;
        assertThat(isPiled(mode)).isEqualTo(rests);
    }

    /** A sleeper on the floor, and who comes to it; returns the pair of the two. */
    private int sleeper(int visitor, double height) {
        bodies.awake[box] = false;
        int pair = pile.contact(box, visitor, 2);
        pairs.separation[2 * pair] = height;
        pairs.separation[2 * pair + 1] = height;
        pairs.pointX[2 * pair] = -0.5;
        pairs.pointX[2 * pair + 1] = 0.5;
        return pair;
    }

    /** The floor's contact is left to sleep: only the visitor is looked at. */
    private boolean isWoken() {
        pairs.points[contact] = 0;
        pile.accept();
        new PileClassifier(pile.data, GAME, ImpactMode.EVENTS).classify(DT);
        assertThat(bodies.piled[box]).as("in a pile if awake").isEqualTo(bodies.awake[box]);
        return bodies.awake[box];
    }

    @Test
    void whatComesToRestOnASleeperWakesIt() {
        sleeper(falling(pile), 0);
        assertThat(isWoken()).isTrue();
    }

    @Test
    void whatFliesOverASleeperDoesNotWakeIt() {
        int visitor = falling(pile);
        bodies.velocityY[visitor] = -1;
        sleeper(visitor, 0.01);
        assertThat(isWoken()).isFalse();
    }

    /** It is asleep or in flight by itself: none but a sleeper can be woken into a pile. */
    @Test
    void whatIsDrivenLeavesFlyersToFlight() {
        int lift = pile.body(BodyType.KINEMATIC);
        bodies.velocityY[lift] = -2;
        sleeper(lift, 0.01);
        bodies.awake[box] = true;
        pairs.points[contact] = 0;
        pile.accept();
        new PileClassifier(pile.data, GAME, ImpactMode.EVENTS).classify(DT);
        assertThat(bodies.piled[box]).isFalse();
    }

    /** On a platform that stands: who comes to rest there leans on it alone. */
    @Test
    void whoComesToRestOnAPlatformWakesNobodyElseThere() {
        int platform = pile.body(BodyType.KINEMATIC);
        int sleeping = falling(pile);
        bodies.awake[sleeping] = false;
        pairs.touching[pairs.add(bodies, platform, sleeping)] = true;
        int landed = falling(pile);
        pile.contact(platform, landed, 1);
        isPiled();
        assertThat(bodies.piled[landed]).isTrue();
        assertThat(bodies.awake[sleeping]).isFalse();
    }

    /** Pairs of an earlier step are still written behind the list of this one. */
    @Test
    void onlyPairsOfThisStepAreLookedAt() {
        int visitor = falling(pile);
        int last = sleeper(visitor, 0);
        pairs.beginStep();
        for (int pair = 0; pair < last; pair++) {
            pairs.points[pair] = 0;
            pairs.activate(pair);
        }
        pile.accept();
        PileClassifier classifier = new PileClassifier(pile.data, GAME, ImpactMode.EVENTS);
        classifier.classify(DT);
        assertThat(pairs.resting[last]).isFalse();
        assertThat(bodies.awake[box]).isFalse();
        bodies.piled[visitor] = true;
        classifier.classify(DT);
        assertThat(bodies.awake[box]).isFalse();
    }

    /** An arm that turns towards a sleeper, but at an end that is not there: the other parts. */
    @Test
    void whatTurnsReachesWithNoEndThatIsNotThere() {
        int arm = pile.body(BodyType.KINEMATIC);
        bodies.spin[arm] = 4;
        pairs.points[sleeper(arm, 0.01)] = 1;
        boolean leftCloses = isWoken();
        bodies.awake[box] = false;
        bodies.piled[box] = false;
        bodies.spin[arm] = -4;
        assertThat(isWoken()).isNotEqualTo(leftCloses);
    }

    /** 2 m/s for 1/64 s is 1/32 m. */
    @ParameterizedTest(name = "{0} m before a lift at {1} m/s: woken is {2}")
    @CsvSource({
        "0.03125, -2, true",
        "0.0313, -2, false",
        "0.03, -2, true",
        "0.03, 2, false",
        "0.01, -0.1, false"
    })
    void whatIsDrivenWakesWhatItReachesInThisStep(double height, double speed, boolean wakes) {
        int lift = pile.body(BodyType.KINEMATIC);
        bodies.velocityY[lift] = speed;
        sleeper(lift, height);
        assertThat(isWoken()).isEqualTo(wakes);
    }

    @Test
    void whatIsDrivenAndFarWakesNobody() {
        int lift = pile.body(BodyType.KINEMATIC);
        bodies.velocityY[lift] = -1000;
        pairs.points[sleeper(lift, 0)] = 0;
        assertThat(isWoken()).isFalse();
    }

    /** The end that comes nearest in turning: 4 rad/s at half a metre are 2 m/s. */
    @ParameterizedTest
    @ValueSource(doubles = {4, -4})
    void whatTurnsReachesWithItsEnd(double spin) {
        int arm = pile.body(BodyType.KINEMATIC);
        bodies.spin[arm] = spin;
        int pair = sleeper(arm, 0.03);
        assertThat(isWoken()).isTrue();
        bodies.awake[box] = false;
        bodies.piled[box] = false;
        pairs.separation[2 * pair] = 0.032;
        pairs.separation[2 * pair + 1] = 0.032;
        assertThat(isWoken()).isFalse();
    }

    /** A pile's member that comes from a side, and is the lower slot. */
    @Test
    void aPileThatMovesWakesWhatItReaches() {
        int next = pile.body(BodyType.DYNAMIC);
        bodies.awake[next] = false;
        int pair = pile.contact(box, next, 1);
        pairs.separation[2 * pair] = 0.03;
        bodies.velocityX[box] = 2;
        pairs.normalX[pair] = 1;
        pairs.normalY[pair] = 0;
        assertThat(isPiled()).isTrue();
        assertThat(bodies.awake[next]).isTrue();
        assertThat(bodies.piled[next]).isTrue();
    }

    @Test
    void withoutRotationADrivenBodyReachesAsFarAsItGoes() {
        Pile plain = new Pile(new Contacts());
        int sleeper = plain.body(BodyType.DYNAMIC);
        int lift = plain.body(BodyType.KINEMATIC);
        plain.bodies.awake[sleeper] = false;
        plain.bodies.velocityY[lift] = -2;
        int pair = plain.contact(sleeper, lift, 1);
        PileClassifier classifier = new PileClassifier(plain.data, GAME, ImpactMode.EVENTS);
        plain.pairs.separation[2 * pair] = 0.0313;
        classifier.classify(DT);
        assertThat(plain.bodies.awake[sleeper]).isFalse();
        plain.pairs.separation[2 * pair] = 0.0312;
        classifier.classify(DT);
        assertThat(plain.bodies.awake[sleeper]).isTrue();
    }

    /** Whom it leans on is woken with it, and its own contacts are looked at in this very step. */
    @Test
    void whatIsWokenBringsItsNeighbours() {
        int visitor = falling(pile);
        sleeper(visitor, 0);
        int under = pile.body(BodyType.DYNAMIC);
        bodies.awake[under] = false;
        int below = pairs.add(bodies, box, under);
        pairs.touching[below] = true;
        int active = pairs.activeCount;
        assertThat(isWoken()).isTrue();
        assertThat(bodies.awake[under]).isTrue();
        assertThat(bodies.piled[under]).isTrue();
        assertThat(pairs.activeCount).isEqualTo(active + 1);
    }
}
