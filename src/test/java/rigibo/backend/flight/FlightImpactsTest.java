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
import rigibo.backend.storage.Quarantine;

/** Simultaneous impacts: which bodies are struck together, and where the two of a pair touch. */
class FlightImpactsTest {

    private final OneInstant instant = new OneInstant();
    private final Air air = instant.air;
    private final FlightImpacts impacts = instant.impacts;

    /** Both bodies are advanced to the time of the impact and touch there. */
    @Test
    void bodiesMeetWhereTheyAreThen() {
        air.add(Air.disc(0, 2, 1));
        air.add(Air.disc(3, 0, 1));
        instant.begin(1);
        impacts.meet(0, 0.5);

        assertThat(air.bodies.x[0]).isEqualTo(1);
        assertThat(air.pairs.points[0]).isEqualTo(1);
        assertThat(air.pairs.normalX[0]).isEqualTo(1);
        assertThat(air.pairs.separation[0]).isEqualTo(0, within(1e-15));
        assertThat(air.pairs.pointX[0]).isEqualTo(2, within(1e-15));
    }

    @Test
    void bringsFlyersOnly() {
        air.add(Air.disc(0, 2, 1));
        air.add(Air.disc(9, 2, 1));
        instant.begin(1);
        air.pile(1);
        impacts.bring(0, 0.5);
        impacts.bring(1, 0.5);

        assertThat(air.bodies.x).startsWith(1, 9);
    }

    /**
     * A flat box strikes with both corners; tilted by more than the tolerance, with the lower one.
     */
    @ParameterizedTest
    @CsvSource({"0, 2", "1e-5, 2", "1e-3, 1"})
    void whatIsAsNearAsTheNearestStrikes(double angle, int points) {
        instant.layFloor(0.5);
        double y = Math.cos(angle) + Math.sin(angle);
        air.add(Air.body(Polygon.box(2, 2), 0).at(0, y).angle(angle).velocity(0, -1));
        instant.begin(0.01);
        impacts.meet(0, 0);

        assertThat(impacts.expectedImpact(0).points).isEqualTo(points);
    }

    /** The other corner of a box of 2 m is 2·sin α higher; the tolerance is stated per metre. */
    @ParameterizedTest
    @CsvSource({"0.9, 2", "1.1, 1"})
    void theToleranceScalesWithTheWidth(double share, int points) {
        instant.layFloor(0.5);
        double angle = share * Accuracy.GAME.impactTolerance();
        double y = Math.cos(angle) + Math.sin(angle);
        air.add(Air.body(Polygon.box(2, 2), 0).at(0, y).angle(angle).velocity(0, -1));
        instant.begin(0.01);
        impacts.meet(0, 0);

        assertThat(impacts.expectedImpact(0).points).isEqualTo(points);
    }

    /** Where the search for an impact gives up, both bodies join the pile without an impact. */
    @Test
    void whatHasNotMetIsNoImpact() {
        instant.layFloor(0.5);
        air.add(Air.body(new Circle(1), 0).at(0, 1.5).velocity(0, -1));
        air.pull(0, -10);
        instant.begin(1);
        instant.strike(0.125, 1, 0);

        assertThat(air.bodies.piled[1]).isTrue();
        assertThat(air.bodies.pileTime[1]).isEqualTo(0.125);
        assertThat(air.pairs.touched(0)).isFalse();
        assertThat(air.pairs.resting[0]).isFalse();
        assertThat(air.storage.data.counters.impacts).isZero();
        assertThat(air.storage.data.counters.settledPairs).isZero();
    }

    /** A body that is apart at the common time, because it is fast, flies on. */
    @Test
    void whatIsOnlyTiedAndHasNotMetFliesOn() {
        air.add(Air.disc(0, 1, 1));
        air.add(Air.disc(2, 0, 1));
        air.add(Air.disc(4.5, -1e6, 1));
        instant.begin(1);
        instant.strike(0, 1, air.pairOf(0, 1), air.pairOf(1, 2));

        assertThat(air.bodies.piled).startsWith(false, false, false);
        assertThat(air.pairs.touched(air.pairOf(1, 2))).isFalse();
        assertThat(air.bodies.velocityX).startsWith(new double[] {0, 1, -1e6}, within(1e-12));
    }

    /**
     * Three discs in a row at once: ⅔ of the elastic impact is handed on, by 2j₁ − j₂ = 2v and j₁ =
     * 2j₂.
     */
    @Test
    void impactsThatShareABodyAreOne() {
        air.add(Air.disc(0, 3, 1));
        air.add(Air.disc(2, 0, 1));
        air.add(Air.disc(4, 0, 1));
        instant.begin(1);
        instant.strike(0, 1, air.pairOf(0, 1), air.pairOf(1, 2));

        assertThat(air.bodies.velocityX).startsWith(new double[] {-1, 2, 2}, within(1e-12));
        assertThat(air.pairs.impulse[air.pairOf(0, 1)]).isEqualTo(4, within(1e-12));
        assertThat(air.storage.data.counters.impacts).isEqualTo(2);
    }

    /** A wall transmits nothing, so two bodies that hit it at once are not connected. */
    @Test
    void aWallInCommonIsNoTie() {
        instant.layFloor(1);
        air.add(Air.body(new Circle(1), 0).at(-2, 1).velocity(0, -1));
        air.add(Air.body(new Circle(1), 0).at(2, 1).velocity(0, -3));
        instant.begin(1);
        instant.strike(0, 1, air.pairOf(0, 1), air.pairOf(0, 2));

        assertThat(air.bodies.velocityY).startsWith(0, 1, 3);
    }

    /** The next impacts are not connected to these. */
    @Test
    void meetingsAreForgotten() {
        impactsThatShareABodyAreOne();
        air.bodies.velocityX[0] = 3;
        air.bodies.velocityX[1] = 0;
        instant.strike(0, 1, air.pairOf(0, 1));

        assertThat(air.bodies.velocityX).startsWith(new double[] {0, 3, 2}, within(1e-12));
    }

    /** All pairs may meet at the same time; equal discs exchange their velocities. */
    @Test
    void anInstantHoldsAllPairs() {
        int[] all = new int[40];
        for (int i = 0; i < 40; i++) {
            air.add(Air.disc(5 * i, i + 1, 1));
            air.add(Air.disc(5 * i + 2, 0, 1));
        }
        instant.begin(1e-3);
        for (int i = 0; i < 40; i++) {
            all[i] = air.pairOf(2 * i, 2 * i + 1);
        }
        instant.strike(0, 1e-3, all);

        for (int i = 0; i < 40; i++) {
            assertThat(air.bodies.velocityX[2 * i]).isZero();
            assertThat(air.bodies.velocityX[2 * i + 1]).isEqualTo(i + 1, within(1e-14));
        }
    }

    /**
     * Struck by a heavy body at e = 1, a light one would leave at twice the speed, beyond all
     * bounds.
     */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void whoIsStruckBeyondAllBoundsIsPutToRest(int heavy) {
        for (int slot = 0; slot < 2; slot++) {
            air.add(Air.disc(2 * slot, 0, 1).mass(slot == heavy ? 1e9 : 1));
        }
        instant.begin(1e-6);
        double speed = 0.75 * Quarantine.FASTEST;
        air.bodies.velocityX[heavy] = heavy == 0 ? speed : -speed;
        instant.strike(0, 1e-6, 0);

        assertThat(air.bodies.velocityX[1 - heavy]).isZero();
        assertThat(Math.abs(air.bodies.velocityX[heavy])).isCloseTo(speed, within(speed * 1e-6));
        assertThat(air.storage.data.counters.quarantinedCount).isEqualTo(1);
    }
}
