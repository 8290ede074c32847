package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** A pair that reached the limit of impacts in a step comes to rest, waits, or joins a pile. */
class CapOfImpactsTest {

    private final OneInstant instant = new OneInstant();
    private final Air air = instant.air;
    private final Trajectories paths = instant.paths;
    private final FlightImpacts impacts = instant.impacts;

    /** Leaves the first pair a number of impacts, the present one included. */
    private void leave(int impacts) {
        leave(1, impacts);
    }

    /** As above, with a factor on the limit. */
    private void leave(int factor, int impacts) {
        air.pairs.impacts[0] = factor * Accuracy.GAME.maxImpactsPerPair() - impacts;
    }

    /** The report counts the pairs that came to rest and those that reached the limit. */
    @ParameterizedTest
    @CsvSource({"0.5, false, 1, 0", "1, false, 0, 0", "0.5, true, 0, 1", "1, true, 0, 1"})
    void whatEndsIsCounted(double elasticity, boolean isLast, int settled, int capped) {
        instant.layFloor(elasticity);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -1));
        air.pull(0, -10);
        instant.begin(1);
        if (isLast) {
            leave(1);
        }
        instant.strike(0, 1, 0);

        assertThat(air.storage.data.counters.settledPairs).isEqualTo(settled);
        assertThat(air.storage.data.counters.cappedPairs).isEqualTo(capped);
    }

    /** Both bodies of a pair at its limit join the pile with their present speeds. */
    @Test
    void bothOfAPairThatMetTooOftenLand() {
        strikeForTheLastTime(0.5, 1);

        assertThat(air.bodies.piled).startsWith(true, true);
        assertThat(air.bodies.velocityX).startsWith(-0.5, 0.5);
    }

    /** Two dynamic bodies cannot wait, since their centre of mass moves on. */
    @Test
    void twoThatBothMoveDoNotStand() {
        strikeForTheLastTime(1, 16);

        assertThat(air.bodies.piled).startsWith(true, true);
        assertThat(air.bodies.velocityX).startsWith(-1, 1);
    }

    /** Two dynamic bodies with an elasticity of 1 have sixteen times the limit of others. */
    @Test
    void twoThatLoseNothingChatterOn() {
        strikeForTheLastTime(1, 1);

        assertThat(air.bodies.piled).startsWith(false, false);
        assertThat(air.bodies.velocityX).startsWith(-1, 1);
    }

    /** Two discs meet at 1 m/s each, in the last impact that the limit allows. */
    private void strikeForTheLastTime(double elasticity, int factor) {
        air.add(Air.disc(0, 1, elasticity));
        air.add(Air.disc(2, -1, elasticity));
        instant.begin(1);
        leave(factor, 1);
        instant.strike(0, 1, 0);
    }

    /**
     * Two bodies that are already parting do not rest on each other if nothing presses them
     * together.
     */
    @Test
    void whatPartsUnpressedDoesNotRest() {
        air.add(Air.disc(0, -1, 1));
        air.add(Air.disc(2, 1, 1));
        instant.begin(1);
        leave(1);
        instant.strike(0, 1, 0);

        assertThat(air.pairs.resting[0]).isFalse();
        assertThat(air.bodies.velocityX).startsWith(-1, 1);
    }

    /**
     * In the last impact that the limit allows, a rebound by less than half a millimetre per metre
     * of width (2 m here) is not visible: v² ≤ 2·g·10⁻³. Then the pair rests. A faster pair with an
     * elasticity of 1 waits for the rest of the step.
     */
    @ParameterizedTest
    @CsvSource({"10, 0.1414, true", "10, 0.1415, false", "0.5, 0.0316, true", "0.5, 0.0317, false"})
    void theLastImpactIsRestOrTheEndOfMotion(double pull, double speed, boolean rests) {
        instant.layFloor(1);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -speed));
        air.pull(0, -pull);
        instant.begin(1);
        leave(1);
        instant.strike(0, 1, 0);

        assertThat(air.pairs.resting[0]).isEqualTo(rests);
        assertThat(air.bodies.piled[1]).isEqualTo(rests);
        assertThat(paths.stands(1)).isEqualTo(!rests);
        assertThat(air.bodies.velocityY[1]).isEqualTo(rests ? 0 : speed, within(1e-15));
        assertThat(air.bodies.pileTime[1]).isEqualTo(rests ? 1 : 0);
    }

    /** Before the limit is reached, a pair rebounds by its elasticity. */
    @Test
    void beforeTheLastImpactItBounces() {
        instant.layFloor(1);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(0, -0.1));
        air.pull(0, -10);
        instant.begin(1);
        leave(2);
        instant.strike(0, 1, 0);

        assertThat(air.bodies.piled[1]).isFalse();
        assertThat(air.bodies.velocityY[1]).isEqualTo(0.1, within(1e-15));
    }

    /**
     * A body with an elasticity of 1 waits at a wall for the rest of the step and keeps its speed.
     */
    @Test
    void whatLosesNothingAtAWallStands() {
        instant.layFloor(1);
        air.add(Air.body(new Circle(1), 0).at(0, 1).velocity(2, -3).spin(4));
        instant.begin(1);
        leave(1);
        instant.strike(0, 1, 0);
        impacts.bring(1, 0.5);

        assertThat(air.bodies.piled[1]).isFalse();
        assertThat(air.bodies.x[1]).isZero();
        assertThat(air.bodies.y[1]).isEqualTo(1);
        assertThat(air.bodies.angle[1]).isZero();
        assertThat(air.bodies.velocityX[1]).isEqualTo(2);
        assertThat(air.bodies.velocityY[1]).isEqualTo(3, within(1e-14));
        assertThat(air.bodies.spin[1]).isEqualTo(4);
    }

    /** A body that hits a waiting one is struck as if that one moved, and waits as well. */
    @ParameterizedTest
    @CsvSource({"0, 3, -1, 3", "0, -2, -2, -1", "1, 3, -1, 3", "1, -2, -2, -1"})
    void whoRunsIntoOneThatStandsStands(
            int standing, double speed, double after, double ofStanding) {
        int runner = 1 - standing;
        for (int slot = 0; slot < 2; slot++) {
            air.add(slot == standing ? Air.disc(0, -1, 1) : Air.disc(-2, speed, 1));
        }
        instant.begin(1);
        paths.stand(standing);
        instant.strike(0, 1, 0);

        assertThat(paths.stands(runner)).isTrue();
        assertThat(paths.stands(standing)).isTrue();
        assertThat(air.bodies.velocityX[runner]).isEqualTo(after);
        assertThat(air.bodies.velocityX[standing]).isEqualTo(ofStanding);
    }

    /** A driven wall does not wait, so the body in its way joins the pile. */
    @Test
    void whoStandsInTheWayOfADrivenBodyLands() {
        air.add(Air.disc(0, -1, 1));
        air.add(
                BodyDefinition.kinematic(Polygon.box(1, 20))
                        .at(1.5, 0)
                        .velocity(-0.5, 0)
                        .material(new Material(1, 0, 0)));
        instant.begin(1);
        paths.stand(0);
        instant.strike(0, 1, 0);

        assertThat(air.bodies.piled[0]).isTrue();
        assertThat(air.bodies.velocityX[0]).isEqualTo(-1);
    }
}
