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

/** Sleepers woken by a body that comes to rest on them, or that a step brings near. */
class WakingIntoPilesTest {

    private static final double G = 8;
    private static final double DT = 1.0 / 64;
    private static final Accuracy GAME = Accuracy.GAME.withImpactTolerance(1e-4);

    private final Pile pile = new Pile(new Gravity(0, -G), new Contacts(), new Rotation());
    private final Bodies bodies = pile.bodies;
    private final Pairs pairs = pile.pairs;

    private final int floor = pile.body(BodyType.STATIC);
    private final int box = pile.falling(G);
    private final int contact = pile.contact(floor, box, 2);

    private void classify() {
        pile.accept();
        new PileClassifier(pile.data, GAME, ImpactMode.EVENTS).classify(DT);
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
        classify();
        assertThat(bodies.piled[box]).as("in a pile if awake").isEqualTo(bodies.awake[box]);
        return bodies.awake[box];
    }

    @Test
    void whatComesToRestOnASleeperWakesIt() {
        sleeper(pile.falling(G), 0);
        assertThat(isWoken()).isTrue();
    }

    @Test
    void whatFliesOverASleeperDoesNotWakeIt() {
        int visitor = pile.falling(G);
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
        classify();
        assertThat(bodies.piled[box]).isFalse();
    }

    /** On a platform that stands: who comes to rest there leans on it alone. */
    @Test
    void whoComesToRestOnAPlatformWakesNobodyElseThere() {
        int platform = pile.body(BodyType.KINEMATIC);
        int sleeping = pile.falling(G);
        bodies.awake[sleeping] = false;
        pairs.touching[pairs.add(bodies, platform, sleeping)] = true;
        int landed = pile.falling(G);
        pile.contact(platform, landed, 1);
        classify();
        assertThat(bodies.piled[landed]).isTrue();
        assertThat(bodies.awake[sleeping]).isFalse();
    }

    /** Pairs of an earlier step are still written behind the list of this one. */
    @Test
    void onlyPairsOfThisStepAreLookedAt() {
        int visitor = pile.falling(G);
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
        classify();
        assertThat(bodies.piled[box]).isTrue();
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
        int visitor = pile.falling(G);
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
