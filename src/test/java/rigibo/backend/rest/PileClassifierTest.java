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
    private final int box = pile.falling(G);
    private final int contact = contactAfterOthers();

    PileClassifierTest() {
        pairs.pointX[2 * contact] = -0.5;
        pairs.pointX[2 * contact + 1] = 0.5;
    }

    /**
     * The contact of the box with the floor, whose number comes after three pairs without points.
     */
    private int contactAfterOthers() {
        int far = pile.body(BodyType.STATIC);
        for (int i = 0; i < 3; i++) {
            pile.contact(pile.body(BodyType.STATIC), far, 0);
        }
        return pile.contact(floor, box, 2);
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

    /** A pair deeper in overlap than any pair at rest is pushed apart, however it moves. */
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
        int upper = plain.falling(G);
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
        int carried = pile.falling(G);
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
        int lower = pile.falling(G);
        int upper = pile.falling(G);
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
}
