package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.collision.Motion;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.impact.Impact;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Quarantine;

/** Blows of one instant, and how bounces end, against Zeno's series. */
class BlowsTest {

    private final Air air = new Air(Accuracy.GAME);
    private final Trajectories paths = new Trajectories(air.bodies);
    private final Blows blows =
            new Blows(air.storage.data, air.narrowphase, Accuracy.GAME, paths, null);

    /** A floor with its top at y = 0 in slot 0. */
    private void layFloor(double elasticity) {
        air.add(
                BodyDefinition.fixed(Polygon.box(20, 1))
                        .at(0, -0.5)
                        .material(new Material(1, 0, elasticity)));
    }

    private void begin(double dt) {
        air.meet(dt);
        paths.begin();
        blows.reserve(air.pairs.bodyA.length);
    }

    private void strike(double time, double dt, int... pairs) {
        blows.strike(pairs, pairs.length, time, dt);
    }

    /**
     * Down at v on the floor with g: the flight after it takes 2ev/g, the next e times as long, and
     * so on: 2ev/(g(1 − e)) in all. A disc slides on meanwhile and rests at the end of it.
     */
    @ParameterizedTest
    @CsvSource({"0.5, 1", "0.25, 2", "0.75, 0.5"})
    void bouncesEndWithZenosSeries(double elasticity, double speed) {
        layFloor(elasticity);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(3, -speed));
        air.pull(0, -10);
        begin(2);
        strike(0.125, 2, 0);

        double begun = 0.125;
        double left = 2 * elasticity * (speed + 10 * begun) / (10 * (1 - elasticity));
        assertThat(air.pairs.resting[0]).isTrue();
        assertThat(air.pairs.touching[0]).isTrue();
        assertThat(air.bodies.piled[1]).isTrue();
        assertThat(air.bodies.pileTime[1]).isEqualTo(begun + left, within(1e-14));
        assertThat(air.bodies.x[1]).isEqualTo(3 * (begun + left), within(1e-14));
        assertThat(air.bodies.velocityY[1]).isEqualTo(0, within(1e-15));
    }

    /** Bounces take 2ev/(g(1 − e)); without elasticity, or speed, they are over at once. */
    @ParameterizedTest
    @CsvSource({"0.5, 0.1, 0.4", "0, 0.1, 0", "0.5, 0, 0"})
    void theSeriesIsOfWhatPressesAndOfTheSpeed(double elasticity, double speed, double left) {
        layFloor(elasticity);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(3, -speed));
        air.pull(0, -0.5);
        begin(2);
        strike(0, 2, 0);

        assertThat(air.bodies.pileTime[1]).isEqualTo(left, within(1e-14));
        assertThat(air.bodies.x[1]).isEqualTo(3 * left, within(1e-14));
    }

    /** What loses nothing but does not move, either, rests at once. */
    @Test
    void withoutASpeedThereIsNothingToLose() {
        layFloor(1);
        air.add(Air.body(new Circle(1), 0).at(0, 1));
        air.pull(0, -10);
        begin(2);
        strike(0, 2, 0);

        assertThat(air.bodies.piled[1]).isTrue();
        assertThat(air.bodies.pileTime[1]).isZero();
    }

    /** Up to a thousandth of its width a pair touches; farther there is nothing to strike. */
    @ParameterizedTest
    @CsvSource({"0.0015, true", "0.0025, false", "1, false"})
    void whatDoesNotTouchRestsWithoutABlow(double gap, boolean touches) {
        layFloor(0);
        air.add(Air.body(new Circle(1), 0).at(0, 1 + gap).velocity(3, -2));
        air.pull(0, -10);
        begin(2);
        strike(0, 2, 0);

        assertThat(air.bodies.piled[1]).isTrue();
        assertThat(air.bodies.pileTime[1]).isZero();
        assertThat(air.bodies.velocityY[1]).isEqualTo(touches ? 0 : -2, within(1e-15));
    }

    /** Pairs that came to rest are counted, and those that met as often as they may. */
    @ParameterizedTest
    @CsvSource({"0.5, 0, 1, 0", "1, 0, 0, 0", "0.5, 1, 0, 1", "1, 1, 0, 1"})
    void whatEndsIsCounted(double elasticity, int impactsLeft, int settled, int capped) {
        layFloor(elasticity);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -1));
        air.pull(0, -10);
        begin(1);
        air.pairs.impacts[0] = impactsLeft == 1 ? Accuracy.GAME.maxImpactsPerPair() - 1 : 0;
        strike(0, 1, 0);

        assertThat(air.storage.data.counters.settledPairs).isEqualTo(settled);
        assertThat(air.storage.data.counters.cappedPairs).isEqualTo(capped);
    }

    /** Both of a pair that met too often are left to the pile, with the speeds they have. */
    @Test
    void bothOfAPairThatMetTooOftenLand() {
        strikeForTheLastTime(0.5);

        assertThat(air.bodies.piled).startsWith(true, true);
        assertThat(air.bodies.velocityX).startsWith(-0.5, 0.5);
    }

    /** At a wall where nothing is lost one stands for the rest of the step, with its speed. */
    @Test
    void whatLosesNothingAtAWallStands() {
        layFloor(1);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(2, -3).spin(4));
        begin(1);
        air.pairs.impacts[0] = Accuracy.GAME.maxImpactsPerPair() - 1;
        strike(0, 1, 0);
        blows.bring(1, 0.5);

        assertThat(air.bodies.piled[1]).isFalse();
        assertThat(air.bodies.x[1]).isZero();
        assertThat(air.bodies.y[1]).isEqualTo(1);
        assertThat(air.bodies.angle[1]).isZero();
        assertThat(air.bodies.velocityX[1]).isEqualTo(2);
        assertThat(air.bodies.velocityY[1]).isEqualTo(3, within(1e-14));
        assertThat(air.bodies.spin[1]).isEqualTo(4);
    }

    /** Two that both move do not stand: their centre of mass goes on, whatever they do. */
    @Test
    void twoThatBothMoveDoNotStand() {
        strikeForTheLastTime(1);

        assertThat(air.bodies.piled).startsWith(true, true);
        assertThat(air.bodies.velocityX).startsWith(-1, 1);
    }

    /** Two discs meet at 1 m/s each, as often as they may. */
    private void strikeForTheLastTime(double elasticity) {
        air.add(Air.disc(0, 1, elasticity));
        air.add(Air.disc(2, -1, elasticity));
        begin(1);
        air.pairs.impacts[0] = Accuracy.GAME.maxImpactsPerPair() - 1;
        strike(0, 1, 0);
    }

    /** Where nothing presses, a blow that finds them parting already is not the end of bounces. */
    @Test
    void whatPartsUnpressedDoesNotRest() {
        air.add(Air.disc(0, -1, 1));
        air.add(Air.disc(2, 1, 1));
        begin(1);
        air.pairs.impacts[0] = Accuracy.GAME.maxImpactsPerPair() - 1;
        strike(0, 1, 0);

        assertThat(air.pairs.resting[0]).isFalse();
        assertThat(air.bodies.velocityX).startsWith(-1, 1);
    }

    /** What runs into one that stands is struck as if it moved, and stands as well. */
    @ParameterizedTest
    @CsvSource({"3, -1, 3", "-2, -2, -1"})
    void whoRunsIntoOneThatStandsStands(double speed, double after, double ofStanding) {
        air.add(Air.disc(0, -1, 1));
        air.add(Air.disc(-2, speed, 1));
        begin(1);
        paths.stand(0);
        strike(0, 1, 0);

        assertThat(paths.stands(1)).isTrue();
        assertThat(air.bodies.velocityX).startsWith(ofStanding, after);
    }

    /** A driven wall does not wait: who stands in its way is left to the pile. */
    @Test
    void whoStandsInTheWayOfADrivenBodyLands() {
        air.add(Air.disc(0, -1, 1));
        air.add(
                BodyDefinition.kinematic(Polygon.box(1, 20))
                        .at(1.5, 0)
                        .velocity(-0.5, 0)
                        .material(new Material(1, 0, 0)));
        begin(1);
        paths.stand(0);
        strike(0, 1, 0);

        assertThat(air.bodies.piled[0]).isTrue();
        assertThat(air.bodies.velocityX[0]).isEqualTo(-1);
    }

    /** As many pairs as there are may meet at one instant: equal discs exchange. */
    @Test
    void anInstantHoldsAllPairs() {
        int[] all = new int[40];
        for (int i = 0; i < 40; i++) {
            air.add(Air.disc(5 * i, i + 1, 1));
            air.add(Air.disc(5 * i + 2, 0, 1));
        }
        begin(1e-3);
        for (int i = 0; i < 40; i++) {
            all[i] = air.pairOf(2 * i, 2 * i + 1);
        }
        strike(0, 1e-3, all);

        for (int i = 0; i < 40; i++) {
            assertThat(air.bodies.velocityX[2 * i]).isZero();
            assertThat(air.bodies.velocityX[2 * i + 1]).isEqualTo(i + 1, within(1e-14));
        }
    }

    /** Struck by a heavy one at e = 1 it would leave at twice the speed, beyond all bounds. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void whoIsStruckBeyondAllBoundsIsPutToRest(int heavy) {
        for (int slot = 0; slot < 2; slot++) {
            air.add(Air.disc(2 * slot, 0, 1).mass(slot == heavy ? 1e9 : 1));
        }
        begin(1e-6);
        double speed = 0.75 * Quarantine.FASTEST;
        air.bodies.velocityX[heavy] = heavy == 0 ? speed : -speed;
        strike(0, 1e-6, 0);

        assertThat(air.bodies.velocityX[1 - heavy]).isZero();
        assertThat(Math.abs(air.bodies.velocityX[heavy])).isCloseTo(speed, within(speed * 1e-6));
        assertThat(air.storage.data.counters.quarantinedCount).isEqualTo(1);
    }

    /** What the series needs does not fit into the step: it bounces by its elasticity. */
    @Test
    void bouncesThatOutlastTheStepGoOn() {
        layFloor(0.5);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -1));
        air.pull(0, -10);
        begin(0.19);
        strike(0, 0.19, 0);

        assertThat(air.bodies.piled[1]).isFalse();
        assertThat(air.pairs.resting[0]).isFalse();
        assertThat(air.bodies.velocityY[1]).isEqualTo(0.5, within(1e-15));
        assertThat(air.pairs.impulse[0]).isEqualTo(1.5, within(1e-15));
        assertThat(air.pairs.impacts[0]).isEqualTo(1);
        assertThat(air.storage.data.counters.impacts).isEqualTo(1);
    }

    /** Where the search for an impact gives up, the two go on in the pile, and have not met. */
    @Test
    void whatHasNotMetIsNoImpact() {
        layFloor(0.5);
        air.add(Air.body(new Circle(1), 0).at(0, 1.5).velocity(0, -1));
        air.pull(0, -10);
        begin(1);
        strike(0.125, 1, 0);

        assertThat(air.bodies.piled[1]).isTrue();
        assertThat(air.bodies.pileTime[1]).isEqualTo(0.125);
        assertThat(air.pairs.touched(0)).isFalse();
        assertThat(air.pairs.resting[0]).isFalse();
        assertThat(air.storage.data.counters.impacts).isZero();
        assertThat(air.storage.data.counters.settledPairs).isZero();
    }

    /** Nothing presses it back: e·v and away. */
    @Test
    void withoutAPullABounceIsTheLast() {
        layFloor(0.5);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -1e-9));
        begin(1e6);
        strike(0, 1e6, 0);

        assertThat(air.bodies.piled[1]).isFalse();
        assertThat(air.bodies.velocityY[1]).isEqualTo(0.5e-9, within(1e-24));
    }

    /** Without elasticity the first bounce is the last, and a box rests where it is. */
    @Test
    void aPlasticBlowRestsAtOnce() {
        landFlat(0, -2);

        assertThat(air.bodies.velocityX[1]).isEqualTo(3);
        assertThat(air.bodies.velocityY[1]).isEqualTo(0, within(1e-14));
        assertThat(air.pairs.resting[0]).isTrue();
        assertThat(air.pairs.impulse[0]).isEqualTo(2, within(1e-14));
    }

    /** A box would turn on the way: it rests where it is, at the time of the blow. */
    @Test
    void aBoxRestsWhereItIs() {
        landFlat(0.5, -1);
    }

    /** A box strikes a floor with its face, at so many m/s, and joins the pile at once, there. */
    private void landFlat(double elasticity, double velocityY) {
        layFloor(elasticity);
        air.add(Air.body(Polygon.box(2, 2), 0).at(0, 1).velocity(3, velocityY));
        air.pull(0, -10);
        begin(1);
        strike(0, 1, 0);

        assertThat(air.bodies.pileTime[1]).isZero();
        assertThat(air.bodies.x[1]).isZero();
    }

    /** A disc that spins turns on while its last bounces go by: ω·2ev/(g(1 − e)). */
    @ParameterizedTest
    @ValueSource(doubles = {4, 1, -1})
    void aDiscTurnsOnWhileItsLastBouncesGoBy(double spin) {
        layFloor(0.5);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -1).spin(spin));
        air.pull(0, -10);
        begin(1);
        strike(0, 1, 0);

        assertThat(air.bodies.angle[1]).isEqualTo(spin * 0.2, within(1e-14));
        assertThat(air.bodies.cos[1]).isEqualTo(Math.cos(spin * 0.2), within(1e-14));
    }

    /** Two that fall alike do not press each other, whatever pulls them. */
    @Test
    void whatFallsTogetherDoesNotPress() {
        air.add(Air.disc(0, 1, 0.5));
        air.add(Air.disc(2, 0, 0.5));
        air.pull(10, -10);
        begin(1);
        strike(0, 1, 0);

        assertThat(air.pairs.resting[0]).isFalse();
        assertThat(air.bodies.velocityX).startsWith(0.25, 0.75);
    }

    /** Only one of them is pulled towards the other, at 10 m/s²: 2·½·1/(10·½) s. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void whatIsPulledTogetherComesToRest(int pulled) {
        air.add(Air.disc(0, 1, 0.5));
        air.add(Air.disc(2, 0, 0.5));
        air.bodies.accelerationX[pulled] = pulled == 0 ? 10 : -10;
        air.bodies.velocityY[0] = 3;
        air.bodies.velocityY[1] = 4;
        begin(1);
        strike(0, 1, 0);

        assertThat(air.bodies.pileTime).startsWith(new double[] {0.2, 0.2}, within(1e-14));
        assertThat(air.bodies.y).startsWith(new double[] {0.6, 0.8}, within(1e-14));
        assertThat(air.bodies.velocityX).startsWith(0.5, 0.5);
    }

    /** What a pile does is not what pulls at it: a flyer is pressed by its own pull alone. */
    @Test
    void aPileIsTakenForSupported() {
        air.add(Air.disc(0, 1, 0.5));
        air.add(Air.disc(2, 0, 0.5));
        air.pull(10, 0);
        begin(1);
        air.pile(1);
        strike(0, 1, 0);

        assertThat(air.bodies.pileTime[0]).isEqualTo(0.2, within(1e-14));
        assertThat(air.bodies.x[1]).as("for the pile's solver to move").isEqualTo(2);
    }

    /**
     * At the last impact a pair may have, a rebound that lifts less than half a millimetre per
     * metre of 2 m is not seen: v² ≤ 2·10·10⁻³. The pair rests; a faster one, which loses nothing,
     * stands for the rest of the step.
     */
    @ParameterizedTest
    @CsvSource({"0.14, true", "0.1420, false"})
    void theLastImpactIsRestOrTheEndOfMotion(double speed, boolean rests) {
        layFloor(1);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -speed));
        air.pull(0, -10);
        begin(1);
        air.pairs.impacts[0] = Accuracy.GAME.maxImpactsPerPair() - 1;
        strike(0, 1, 0);

        assertThat(air.pairs.resting[0]).isEqualTo(rests);
        assertThat(air.bodies.piled[1]).isEqualTo(rests);
        assertThat(paths.stands(1)).isEqualTo(!rests);
        assertThat(air.bodies.velocityY[1]).isEqualTo(rests ? 0 : speed, within(1e-15));
        assertThat(air.bodies.pileTime[1]).isEqualTo(rests ? 1 : 0);
    }

    /** Before its last impact, it bounces as it is told. */
    @Test
    void beforeTheLastImpactItBounces() {
        layFloor(1);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -0.1));
        air.pull(0, -10);
        begin(1);
        air.pairs.impacts[0] = Accuracy.GAME.maxImpactsPerPair() - 2;
        strike(0, 1, 0);

        assertThat(air.bodies.piled[1]).isFalse();
        assertThat(air.bodies.velocityY[1]).isEqualTo(0.1, within(1e-15));
    }

    /**
     * Three in a row at once: ⅔ of the elastic blow is passed on, by 2j₁ − j₂ = 2v and j₁ = 2j₂.
     */
    @Test
    void blowsThatShareABodyAreOne() {
        air.add(Air.disc(0, 3, 1));
        air.add(Air.disc(2, 0, 1));
        air.add(Air.disc(4, 0, 1));
        begin(1);
        strike(0, 1, air.pairOf(0, 1), air.pairOf(1, 2));

        assertThat(air.bodies.velocityX).startsWith(new double[] {-1, 2, 2}, within(1e-12));
        assertThat(air.pairs.impulse[air.pairOf(0, 1)]).isEqualTo(4, within(1e-12));
        assertThat(air.storage.data.counters.impacts).isEqualTo(2);
    }

    /** A wall passes nothing on: two that meet it at once are strangers. */
    @Test
    void aWallInCommonIsNoTie() {
        layFloor(1);
        air.add(Air.body(new Circle(1), 0).at(-2, 1).velocity(0, -1));
        air.add(Air.body(new Circle(1), 0).at(2, 1).velocity(0, -3));
        begin(1);
        strike(0, 1, air.pairOf(0, 1), air.pairOf(0, 2));

        assertThat(air.bodies.velocityY).startsWith(0, 1, 3);
    }

    /** The next instant is not tied to the last. */
    @Test
    void meetingsAreForgotten() {
        blowsThatShareABodyAreOne();
        air.bodies.velocityX[0] = 3;
        air.bodies.velocityX[1] = 0;
        strike(0, 1, air.pairOf(0, 1));

        assertThat(air.bodies.velocityX).startsWith(new double[] {0, 3, 2}, within(1e-12));
    }

    /** Both are brought to the time of the impact, and touch where they are then. */
    @Test
    void bodiesMeetWhereTheyAreThen() {
        air.add(Air.disc(0, 2, 1));
        air.add(Air.disc(3, 0, 1));
        begin(1);
        blows.meet(0, 0.5);

        assertThat(air.bodies.x[0]).isEqualTo(1);
        assertThat(air.pairs.points[0]).isEqualTo(1);
        assertThat(air.pairs.normalX[0]).isEqualTo(1);
        assertThat(air.pairs.separation[0]).isEqualTo(0, within(1e-15));
        assertThat(air.pairs.pointX[0]).isEqualTo(2, within(1e-15));
    }

    /**
     * A pile that comes at 1 m/s is taken for a wall: what meets it at 2 m/s goes back at 1 + 3·½.
     */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void aLanderIsExpectedToReboundAsFromAWall(int lander) {
        air.add(Air.disc(0, lander == 0 ? 2 : 1, 0.5));
        air.add(Air.disc(2, lander == 0 ? -1 : -2, 0.5));
        begin(1);
        air.pile(1 - lander);
        blows.meet(0, 0);
        paths.land(lander, 0);
        blows.expectRebound(0, lander);
        Motion motion = new Motion();
        paths.load(lander, motion);

        assertThat(motion.velocityXAt(1)).isEqualTo(lander == 0 ? -2.5 : 2.5, within(1e-15));
    }

    /** Beside the middle of a box that would turn away, and rough: a wall does not. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void aPileDoesNotTurnAwayFromALander(int lander) {
        BodyDefinition disc = Air.disc(0, 2, 0.5).at(0, 0.75).material(new Material(1, 1, 0.5));
        BodyDefinition box =
                BodyDefinition.dynamic(Polygon.box(2, 2))
                        .mass(1)
                        .at(2, 0)
                        .material(new Material(1, 1, 0.5));
        air.add(lander == 0 ? disc : box);
        air.add(lander == 0 ? box : disc);
        begin(1);
        air.pile(1 - lander);
        blows.meet(0, 0);
        paths.land(lander, 0);
        blows.expectRebound(0, lander);
        Motion motion = new Motion();
        paths.load(lander, motion);

        assertThat(motion.velocityX).isEqualTo(-1, within(1e-14));
    }

    /** Where nothing touches there is no blow to be expected: it goes on as it came. */
    @Test
    void withoutAPointALanderIsExpectedToGoOn() {
        air.add(Air.disc(0, 2, 0.5));
        air.add(Air.disc(3, -1, 0.5));
        begin(1);
        air.pile(1);
        blows.meet(0, 0);
        paths.land(0, 0);
        blows.expectRebound(0, 0);
        Motion motion = new Motion();
        paths.load(0, motion);

        assertThat(motion.velocityX).isEqualTo(2);
    }

    /** The blow is at the velocities expected, not at those in the columns. */
    @Test
    void aBlowIsOfTheVelocitiesExpected() {
        air.add(Air.disc(0, 2, 0.5).spin(1));
        air.add(Air.disc(2, -1, 0.5).spin(2));
        begin(1);
        paths.land(0, 0);
        paths.expect(0, 7, 8, 9);
        paths.land(1, 0);
        paths.expect(1, -7, -8, -9);
        blows.meet(0, 0);
        Impact blow = blows.expectedBlow(0);

        assertThat(new double[] {blow.velocityAX, blow.velocityAY, blow.spinA})
                .containsExactly(7, 8, 9);
        assertThat(new double[] {blow.velocityBX, blow.velocityBY, blow.spinB})
                .containsExactly(-7, -8, -9);
        assertThat(blow.armAX[0]).isEqualTo(1, within(1e-15));
        assertThat(blow.armBX[0]).isEqualTo(-1, within(1e-15));
    }

    /** Flat, both corners strike; tilted by more than the tolerance, the lower one does. */
    @ParameterizedTest
    @CsvSource({"0, 2", "1e-5, 2", "1e-3, 1"})
    void whatIsAsNearAsTheNearestStrikes(double angle, int points) {
        layFloor(0.5);
        double y = Math.cos(angle) + Math.sin(angle);
        air.add(Air.body(Polygon.box(2, 2), 0).at(0, y).angle(angle).velocity(0, -1));
        begin(0.01);
        blows.meet(0, 0);

        assertThat(blows.expectedBlow(0).points).isEqualTo(points);
    }

    /** The other corner of a box of 2 m is 2·sin α higher; the tolerance is told per metre. */
    @ParameterizedTest
    @CsvSource({"0.9, 2", "1.1, 1"})
    void theToleranceScalesWithTheWidth(double share, int points) {
        layFloor(0.5);
        double angle = share * Accuracy.GAME.impactTolerance();
        double y = Math.cos(angle) + Math.sin(angle);
        air.add(Air.body(Polygon.box(2, 2), 0).at(0, y).angle(angle).velocity(0, -1));
        begin(0.01);
        blows.meet(0, 0);

        assertThat(blows.expectedBlow(0).points).isEqualTo(points);
    }

    @Test
    void bringsFlyersOnly() {
        air.add(Air.disc(0, 2, 1));
        air.add(Air.disc(9, 2, 1));
        begin(1);
        air.pile(1);
        blows.bring(0, 0.5);
        blows.bring(1, 0.5);

        assertThat(air.bodies.x).startsWith(1, 9);
    }
}
