package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

/** A box on another one, and the results of a step of 0.1 s in substeps of 0.02 s. */
class IslandResultsTest {

    private static final double H = 0.02;
    private static final double LENGTH = 0.1;
    private static final double ROUND_OFF = 1e-14;

    /** The contact's row; the first row belongs to another box. */
    private static final int ROW = 1;

    private final StoredIsland island = StoredIsland.turning();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final PackedTurns turns = island.turns;
    private final RowBuilder builder = island.builder;
    private final IslandResults results = new IslandResults(island.data, motions, contacts, turns);
    private int driven;
    private int lower;
    private int upper;
    private int pair;

    @BeforeEach
    void lay() {
        driven = island.body(BodyDefinition.kinematic(Polygon.box(1, 1)).at(9, 9).velocity(1, 0));
        lower = island.body(BodyDefinition.dynamic(Polygon.box(1, 1)));
        upper = island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 1).angle(0.2));
        int beside = island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).at(1, 0));
        island.point(island.contact(lower, beside, 0), 0.5, 0, 1);
        pair = island.contact(lower, upper, Math.PI / 2);
        island.point(pair, -0.4, 0.5, -0.001);
        island.point(pair, 0.4, 0.5, -0.002);
        builder.build(0, H / 2);
        builder.offset(driven);
        assertThat(contacts.pair[ROW]).isEqualTo(pair);
    }

    private void carry(double impulse0, double impulse1, double total) {
        contacts.data[ROW * PackedContacts.STRIDE + PackedContacts.IMPULSE0] = impulse0;
        contacts.data[ROW * PackedContacts.STRIDE + PackedContacts.IMPULSE1] = impulse1;
        contacts.data[ROW * PackedContacts.STRIDE + PackedContacts.TOTAL] = total;
    }

    @Test
    void bodiesAreWhereTheyWent() {
        for (int entry = 1; entry < motions.count; entry++) {
            for (int column = 0; column <= Motions.TURN; column++) {
                motions.data[entry * Motions.STRIDE + column] = entry + column / 8.0;
            }
        }
        motions.data[Motions.STRIDE + Motions.TURN] = 0;
        island.bodies.cos[lower] = 7;
        results.store(H, LENGTH);
        int entry = motions.offset(island.bodies, upper) / Motions.STRIDE;
        assertThat(island.bodies.velocityX[upper]).isEqualTo(entry);
        assertThat(island.bodies.velocityY[upper]).isEqualTo(entry + 0.125);
        assertThat(island.bodies.spin[upper]).isEqualTo(entry + 0.25);
        assertThat(island.bodies.x[upper]).isCloseTo(entry + 0.375, within(ROUND_OFF));
        assertThat(island.bodies.y[upper]).isCloseTo(1 + entry + 0.5, within(ROUND_OFF));
        double angle = 0.2 + entry + 0.625;
        assertThat(island.bodies.angle[upper]).isCloseTo(angle, within(ROUND_OFF));
        assertThat(island.bodies.cos[upper]).isCloseTo(Math.cos(angle), within(ROUND_OFF));
        assertThat(island.bodies.sin[upper]).isCloseTo(Math.sin(angle), within(ROUND_OFF));
        // Bodies that did not turn keep cosine and sine.
        assertThat(island.bodies.cos[lower]).isEqualTo(7);
        // Only the step itself moves a driven body.
        assertThat(island.bodies.x[driven]).isEqualTo(9);
        assertThat(island.bodies.y[driven]).isEqualTo(9);
        assertThat(island.bodies.velocityX[driven]).isEqualTo(1);
        assertThat(island.bodies.spin[driven]).isZero();
    }

    /** The impulse of half a substep over its length; a mean over two seconds. */
    @Test
    void forcesAreImpulsesOfTheLastHalfKick() {
        island.pairs.load[2 * pair] = 100;
        island.pairs.load[2 * pair + 1] = 10;
        carry(3, 5, 7);
        results.store(H, LENGTH);
        assertThat(island.pairs.normalForce[2 * pair]).isCloseTo(300, within(1e-12));
        assertThat(island.pairs.normalForce[2 * pair + 1]).isCloseTo(500, within(1e-12));
        double share = 0.05;
        assertThat(island.pairs.load[2 * pair]).isCloseTo(100 + 200 * share, within(1e-12));
        assertThat(island.pairs.load[2 * pair + 1]).isCloseTo(10 + 490 * share, within(1e-12));
        assertThat(island.pairs.impulse[pair]).isEqualTo(7);
        assertThat(island.pairs.touching[pair]).isTrue();
        assertThat(island.pairs.resting[pair]).isTrue();
        assertThat(island.pairs.crushed[pair]).isFalse();
        assertThat(contacts.work.crushed).isZero();
    }

    /** A step longer than the memory leaves nothing of the former mean. */
    @Test
    void longStepForgetsEarlierLoads() {
        island.pairs.load[2 * pair] = 100;
        carry(3, 5, 7);
        results.store(H, 9);
        assertThat(island.pairs.load[2 * pair]).isCloseTo(300, within(1e-12));
    }

    @ParameterizedTest
    @CsvSource({"0, 0, false", "0, 1, true", "1, 0, true"})
    void contactTouchesIfItCarries(double impulse0, double impulse1, boolean touches) {
        carry(impulse0, impulse1, 0);
        results.store(H, LENGTH);
        assertThat(island.pairs.touching[pair]).isEqualTo(touches);
        assertThat(island.pairs.resting[pair]).isEqualTo(touches);
    }

    /** The row of two points that are nearly one carries for the deeper one. */
    @ParameterizedTest
    @CsvSource({"-0.001, -0.002, 1", "-0.002, -0.001, 0", "-0.001, -0.001, 0"})
    void oneRowOfTwoPointsStandsForTheDeeper(double gap0, double gap1, int carrying) {
        island.pairs.separation[2 * pair] = gap0;
        island.pairs.separation[2 * pair + 1] = gap1;
        contacts.points[ROW] = 1;
        carry(3, 0, 3);
        results.store(H, LENGTH);
        assertThat(island.pairs.normalForce[2 * pair + carrying]).isCloseTo(300, within(1e-12));
        assertThat(island.pairs.normalForce[2 * pair + 1 - carrying]).isZero();
    }

    /** Overlap of 0.05 widths is too deep at the start or at the end. */
    @ParameterizedTest
    @CsvSource({"-0.047, true", "-0.049, true", "-0.049, false", "-0.043, false"})
    void contactIsCrushedAtTheEnd(double way, boolean wasCrushed) {
        motions.data[motions.offset(island.bodies, upper) + Motions.DY] = way;
        island.pairs.crushed[pair] = wasCrushed;
        boolean isCrushed = wasCrushed || way < -0.048;
        results.store(H, LENGTH);
        assertThat(island.pairs.crushed[pair]).isEqualTo(isCrushed);
        assertThat(contacts.work.crushed).isEqualTo(isCrushed ? 1 : 0);
    }

    @ParameterizedTest
    @CsvSource({"6, NaN", "7, NaN", "21, Infinity", "6, Infinity", "7, -Infinity"})
    void forcesThatAreNoNumbersAreForgotten(int column, double number) {
        for (int point = 2 * pair; point < 2 * pair + 2; point++) {
            island.pairs.load[point] = 1;
            island.pairs.normalForce[point] = 1;
        }
        carry(1, 1, 1);
        contacts.data[ROW * PackedContacts.STRIDE + column] = number;
        results.store(H, LENGTH);
        for (int point = 2 * pair; point < 2 * pair + 2; point++) {
            assertThat(island.pairs.load[point]).isZero();
            assertThat(island.pairs.normalForce[point]).isZero();
        }
        assertThat(island.pairs.impulse[pair]).isZero();
    }

    @Test
    void bodyThatIsTooFastIsPutToRest() {
        island.bodies.velocityX[upper] = 1e300;
        island.bodies.velocityX[lower] = 3;
        results.quarantine();
        assertThat(island.bodies.velocityX[upper]).isZero();
        assertThat(island.bodies.velocityX[lower]).isEqualTo(3);
    }

    /** At rest a step adds its forces times its length, and nothing moves. */
    @Test
    void islandAtRestCarriesOn() {
        island.pairs.normalForce[2 * pair] = 20;
        island.pairs.normalForce[2 * pair + 1] = 30;
        island.pairs.load[2 * pair] = 100;
        island.pairs.crushed[pair] = true;
        results.goOn(0, LENGTH);
        assertThat(island.pairs.load[2 * pair]).isCloseTo(100 - 80 * 0.05, within(1e-12));
        assertThat(island.pairs.load[2 * pair + 1]).isCloseTo(30 * 0.05, within(1e-12));
        assertThat(island.pairs.impulse[pair]).isCloseTo(5, within(1e-12));
        assertThat(island.pairs.touching[pair]).isTrue();
        assertThat(contacts.work.crushed).isEqualTo(1);
        island.pairs.crushed[pair] = false;
        results.goOn(0, 9);
        assertThat(island.pairs.load[2 * pair]).isCloseTo(20, within(1e-12));
        assertThat(contacts.work.crushed).isEqualTo(1);
    }

    @Test
    void withoutRotationNothingIsTurned() {
        motions.data[Motions.STRIDE + Motions.TURN] = 1;
        double before = island.bodies.angle[lower];
        new IslandResults(island.data, motions, contacts, null).store(H, LENGTH);
        assertThat(island.bodies.angle[lower]).isEqualTo(before);
    }
}
