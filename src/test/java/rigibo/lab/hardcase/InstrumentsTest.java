package rigibo.lab.hardcase;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Bounces;

/** Tests of the instruments that judge the engine. */
class InstrumentsTest {

    private static final double CLOSE = 1e-12;

    private final Pool pool = new Pool();

    private RigidBody place(Shape shape, double x, double y, double angle) {
        return pool.add(BodyDefinition.dynamic(shape).at(x, y).angle(angle));
    }

    private double share() {
        return new Overlap().deepestShare(pool.bodies());
    }

    @Test
    void overlapOfBoxesIsTheShorterWayOut() {
        place(Polygon.box(2, 1), 0, 0, 0);
        place(Polygon.box(2, 1), 1.5, 0.9, 0);
        assertThat(share()).isCloseTo(0.1, within(CLOSE));
    }

    @Test
    void overlapOfATurnedBoxIsThatOfItsCorner() {
        place(Polygon.box(4, 1), 0, 0, 0);
        place(Polygon.box(1, 1), 0, 0.5 + Math.sqrt(0.5) - 0.02, Math.PI / 4);
        assertThat(share()).isCloseTo(0.02, within(CLOSE));
    }

    @Test
    void overlapOfDiscAndBoxReachesRoundTheCorner() {
        place(Polygon.box(2, 2), 0, 0, 0);
        double diagonal = Math.sqrt(0.5);
        place(new Circle(0.5), 1 + 0.45 * diagonal, 1 + 0.45 * diagonal, 0);
        assertThat(share()).isCloseTo(0.05, within(CLOSE));
    }

    @Test
    void discInsideABoxIsDeep() {
        place(Polygon.box(4, 4), 0, 0, 0);
        place(new Circle(0.5), 0, 1, 0);
        assertThat(share()).isCloseTo(1.5, within(CLOSE));
    }

    @Test
    void bodiesApartDoNotOverlap() {
        place(new Circle(0.5), 0, 0, 0);
        place(new Circle(0.5), 1, 1e-3, 0);
        place(Polygon.box(1, 1), 0, 1.01, 0);
        assertThat(share()).isZero();
    }

    @Test
    void bouncesFollowTheGeometricSeries() {
        Bounces bounces = new Bounces(2, 0.8);
        assertThat(bounces.restTime()).isCloseTo(5.747, within(5e-4));
        assertThat(bounces.impactTime(200)).isCloseTo(bounces.restTime(), within(1e-9));
        double second = bounces.impactTime(1) + 0.1;
        assertThat(bounces.apexError(second, 1e-3, 1.28)).isCloseTo(0, within(CLOSE));
        assertThat(bounces.apexError(second, 1e-3, 2)).isCloseTo(0.36, within(CLOSE));
    }

    @Test
    void energyOutOfNothingIsFound() {
        Pool flight = new Pool(Effects.of(new Gravity(0, -9.81)), Preset.GAME.accuracy());
        RigidBody disc = flight.add(BodyDefinition.dynamic(new Circle(1)).at(0, 10));
        Balance balance = new Balance(new Gravity(0, -9.81));
        balance.begin(flight.bodies(), 0);
        flight.step(Trial.DT);
        assertThat(balance.end(flight.bodies(), 0, Trial.DT)).isZero();
        assertThat(balance.energyGainShare()).isLessThan(1e-12);
        assertThat(balance.momentumErrorShare()).isLessThan(1e-12);
        balance.begin(flight.bodies(), 0);
        disc.velocity(3, 0);
        balance.end(flight.bodies(), 0, Trial.DT);
        assertThat(balance.energyGainShare()).isGreaterThan(0.01);
        assertThat(balance.momentumErrorShare()).isGreaterThan(0.5);
    }

    @Test
    void figureBeyondItsLimitFails() {
        Measure good = new Measure("x", 1, 2, "m", "here");
        assertThat(good.passes()).isTrue();
        assertThat(good.margin()).isCloseTo(2, within(CLOSE));
        assertThat(new Measure("x", 0, 0, "m", "").margin()).isInfinite();
        assertThat(new Measure("x", 1, 0, "m", "").margin()).isZero();
        assertThat(new Measure("x", Double.NaN, 2, "m", "").margin()).isZero();
        assertThat(good.worse(new Measure("x", 3, 2, "m", "there")).passes()).isFalse();
        assertThat(new Measure("x", Double.NaN, 2, "m", "").passes()).isFalse();
        assertThat(good.worse(new Measure("x", Double.NaN, 2, "m", "")).passes()).isFalse();
    }
}
