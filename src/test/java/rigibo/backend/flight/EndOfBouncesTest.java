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
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** The end of a series of bounces, compared with Zeno's series. */
class EndOfBouncesTest {

    private final OneInstant instant = new OneInstant();
    private final Air air = instant.air;

    /**
     * After an impact at v under g the flight takes 2ev/g, the next one e times as long, and so on:
     * 2ev/(g(1 − e)) in all. A disc slides on meanwhile and rests at the end.
     */
    @ParameterizedTest
    @CsvSource({"0.5, 1", "0.25, 2", "0.75, 0.5"})
    void bouncesEndWithZenosSeries(double elasticity, double speed) {
        instant.layFloor(elasticity);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(3, -speed));
        air.pull(0, -10);
        instant.begin(2);
        instant.strike(0.125, 2, 0);

        double begun = 0.125;
        double left = 2 * elasticity * (speed + 10 * begun) / (10 * (1 - elasticity));
        assertThat(air.pairs.resting[0]).isTrue();
        assertThat(air.pairs.touching[0]).isTrue();
        assertThat(air.bodies.piled[1]).isTrue();
        assertThat(air.bodies.pileTime[1]).isEqualTo(begun + left, within(1e-14));
        assertThat(air.bodies.x[1]).isEqualTo(3 * (begun + left), within(1e-14));
        assertThat(air.bodies.velocityY[1]).isEqualTo(0, within(1e-15));
    }

    /** Bounces take 2ev/(g(1 − e)); at an elasticity or a speed of 0 they end at once. */
    @ParameterizedTest
    @CsvSource({"0.5, 0.1, 0.4", "0, 0.1, 0", "0.5, 0, 0"})
    void theSeriesIsOfWhatPressesAndOfTheSpeed(double elasticity, double speed, double left) {
        instant.layFloor(elasticity);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(3, -speed));
        air.pull(0, -0.5);
        instant.begin(2);
        instant.strike(0, 2, 0);

        assertThat(air.bodies.pileTime[1]).isEqualTo(left, within(1e-14));
        assertThat(air.bodies.x[1]).isEqualTo(3 * left, within(1e-14));
    }

    /** A body with an elasticity of 1 and a speed of 0 rests at once. */
    @Test
    void withoutASpeedThereIsNothingToLose() {
        land(Air.body(new Circle(1), 0).at(0, 1), 1, 2);

        assertThat(air.bodies.piled[1]).isTrue();
        assertThat(air.bodies.pileTime[1]).isZero();
    }

    /** A pair touches up to a thousandth of its width; farther apart there is no impact. */
    @ParameterizedTest
    @CsvSource({"0.0015, true", "0.0025, false", "1, false"})
    void whatDoesNotTouchRestsWithoutAImpact(double gap, boolean touches) {
        land(Air.body(new Circle(1), 0).at(0, 1 + gap).velocity(3, -2), 0, 2);

        assertThat(air.bodies.piled[1]).isTrue();
        assertThat(air.bodies.pileTime[1]).isZero();
        assertThat(air.bodies.velocityY[1]).isEqualTo(touches ? 0 : -2, within(1e-15));
    }

    /** The series is longer than the step: the body rebounds by its elasticity. */
    @Test
    void bouncesThatOutlastTheStepGoOn() {
        land(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -1), 0.5, 0.19);

        assertThat(air.bodies.piled[1]).isFalse();
        assertThat(air.pairs.resting[0]).isFalse();
        assertThat(air.bodies.velocityY[1]).isEqualTo(0.5, within(1e-15));
        assertThat(air.pairs.impulse[0]).isEqualTo(1.5, within(1e-15));
        assertThat(air.pairs.impacts[0]).isEqualTo(1);
        assertThat(air.storage.data.counters.impacts).isEqualTo(1);
    }

    /** The series ends after 2·½·1/(10·½) = 0.2 s, exactly with the step. */
    @Test
    void bouncesThatEndWithTheStepHaveEnded() {
        land(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -1), 0.5, 0.2);

        assertThat(air.pairs.resting[0]).isTrue();
        assertThat(air.bodies.pileTime[1]).isEqualTo(0.2);
        assertThat(air.storage.data.counters.settledPairs).isEqualTo(1);
    }

    /** Without an acceleration the body leaves at e·v. */
    @Test
    void withoutAPullABounceIsTheLast() {
        instant.layFloor(0.5);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -1e-9));
        instant.begin(1e6);
        instant.strike(0, 1e6, 0);

        assertThat(air.bodies.piled[1]).isFalse();
        assertThat(air.bodies.velocityY[1]).isEqualTo(0.5e-9, within(1e-24));
    }

    /** At an elasticity of 0 the first impact is the last, and a box rests in place. */
    @Test
    void aPlasticImpactRestsAtOnce() {
        landFlat(0, -2);

        assertThat(air.bodies.velocityX[1]).isEqualTo(3);
        assertThat(air.bodies.velocityY[1]).isEqualTo(0, within(1e-14));
        assertThat(air.pairs.resting[0]).isTrue();
        assertThat(air.pairs.impulse[0]).isEqualTo(2, within(1e-14));
    }

    /** A box would turn on the way, so it rests in place at the time of the impact. */
    @Test
    void aBoxRestsWhereItIs() {
        landFlat(0.5, -1);
    }

    /** Under 10 m/s² a body strikes a floor at the start of a step of dt seconds. */
    private void land(BodyDefinition body, double elasticity, double dt) {
        instant.layFloor(elasticity);
        air.add(body);
        air.pull(0, -10);
        instant.begin(dt);
        instant.strike(0, dt, 0);
    }

    /** A box strikes a floor flat at a speed in m/s, and joins the pile at once. */
    private void landFlat(double elasticity, double velocityY) {
        land(Air.body(Polygon.box(2, 2), 0).at(0, 1).velocity(3, velocityY), elasticity, 1);

        assertThat(air.bodies.pileTime[1]).isZero();
        assertThat(air.bodies.x[1]).isZero();
    }

    /** A spinning disc turns on during its last bounces, by ω·2ev/(g(1 − e)). */
    @ParameterizedTest
    @ValueSource(doubles = {4, 1, -1})
    void aDiscTurnsOnWhileItsLastBouncesGoBy(double spin) {
        land(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -1).spin(spin), 0.5, 1);

        assertThat(air.bodies.angle[1]).isEqualTo(spin * 0.2, within(1e-14));
        assertThat(air.bodies.cos[1]).isEqualTo(Math.cos(spin * 0.2), within(1e-14));
    }

    /** Two bodies with equal accelerations do not press each other. */
    @Test
    void whatFallsTogetherDoesNotPress() {
        air.add(Air.disc(0, 1, 0.5));
        air.add(Air.disc(2, 0, 0.5));
        air.pull(10, -10);
        instant.begin(1);
        instant.strike(0, 1, 0);

        assertThat(air.pairs.resting[0]).isFalse();
        assertThat(air.bodies.velocityX).startsWith(0.25, 0.75);
    }

    /** One body alone is accelerated towards the other, by 10 m/s²: 2·½·1/(10·½) s. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void whatIsPulledTogetherComesToRest(int pulled) {
        air.add(Air.disc(0, 1, 0.5));
        air.add(Air.disc(2, 0, 0.5));
        air.bodies.accelerationX[pulled] = pulled == 0 ? 10 : -10;
        air.bodies.velocityY[0] = 3;
        air.bodies.velocityY[1] = 4;
        instant.begin(1);
        instant.strike(0, 1, 0);

        assertThat(air.bodies.pileTime).startsWith(new double[] {0.2, 0.2}, within(1e-14));
        assertThat(air.bodies.y).startsWith(new double[] {0.6, 0.8}, within(1e-14));
        assertThat(air.bodies.velocityX).startsWith(0.5, 0.5);
    }

    /** The pile's acceleration does not count: a flyer is pressed by its own acceleration alone. */
    @Test
    void aPileIsTakenForSupported() {
        air.add(Air.disc(0, 1, 0.5));
        air.add(Air.disc(2, 0, 0.5));
        air.pull(10, 0);
        instant.begin(1);
        air.pile(1);
        instant.strike(0, 1, 0);

        assertThat(air.bodies.pileTime[0]).isEqualTo(0.2, within(1e-14));
        assertThat(air.bodies.x[1]).as("for the pile's solver to move").isEqualTo(2);
    }

    /**
     * A ball whose bounces on a floor take 2·0.6·0.03/(9.81·0.4) s = 9.2 ms more rolls at 5 m/s: by
     * 46 mm, but a wall is 1 cm ahead. Flight, and what it hands to the pile, are exact to the
     * tolerance of an impact, a ten-thousandth of a width.
     */
    @ParameterizedTest
    @EnumSource(
            value = Preset.class,
            names = {"GAME", "FINE", "EXACT"})
    void whatRollsOnMeanwhileStopsAtAWall(Preset preset) {
        Pool pool = new Pool(Effects.usual(), preset.accuracy);
        Material elastic = new Material(1, 0.2, 0.6);
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5).material(elastic));
        pool.add(BodyDefinition.fixed(Polygon.box(1, 2)).at(0.76, 1).material(elastic));
        RigidBody ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.25))
                                .at(0, 0.25)
                                .velocity(5, -0.03)
                                .spin(-20)
                                .material(elastic));
        for (int i = 0; i < 6; i++) {
            pool.step(1.0 / 60);
            assertThat(ball.x()).isLessThan(0.26 - 0.25 + 5e-5);
        }
        assertThat(ball.velocityX()).isNegative();
    }

    /**
     * A ball that falls along a wall onto a ramp slides towards the wall, whatever is left of its
     * bounces: before, it flew along the wall and was not to meet it.
     */
    @ParameterizedTest
    @EnumSource(
            value = Preset.class,
            names = {"GAME", "FINE", "EXACT"})
    void whatIsThrownAgainstAWallStopsThere(Preset preset) {
        Pool pool = new Pool(Effects.usual(), preset.accuracy);
        Material dull = new Material(1, 0.2, 0.005);
        pool.add(BodyDefinition.fixed(Polygon.box(1, 20)).at(0.5, 0).material(dull));
        pool.add(BodyDefinition.fixed(Polygon.box(4, 0.4)).at(-1, 0).angle(-0.2).material(dull));
        pool.add(
                BodyDefinition.dynamic(new Circle(0.25))
                        .at(-0.2503, 2)
                        .velocity(0, -3)
                        .material(dull));
        for (int i = 0; i < 60; i++) {
            assertThat(pool.step(1.0 / 60).deepestOverlap()).isLessThan(0.5 * 1e-3);
        }
    }
}
