package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.Need;
import rigibo.backend.storage.Pairs;

/**
 * {@link FreshRows} and {@link BentRows}: the contacts that are measured again, and the results.
 */
class MeasuredRowsTest {

    private static final double ROUND_OFF = 1e-12;

    private final StoredIsland island = StoredIsland.turning();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final RowBuilder builder = island.builder;
    private final FreshRows fresh = island.fresh();
    private final Straightness straight =
            new Straightness(motions, Accuracy.GAME.withImpactTolerance(1e-3));
    private final BentRows bent =
            new BentRows(
                    contacts,
                    fresh,
                    new TurningRows(island.data, motions, contacts, fresh, straight),
                    new CurvedRows(island.data, motions, contacts, straight),
                    new SharedRows(null, contacts));

    private int a;
    private int b;
    private int pair;
    private int row;

    /** Puts A below B, and a third body beside A, whose contact is the first row. */
    private void lay(Convex shapeA, Convex shapeB, double x, double y) {
        a = island.body(BodyDefinition.dynamic(shapeA));
        b = island.body(BodyDefinition.dynamic(shapeB).at(x, y));
        int beside = island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).at(9, 0));
        island.point(island.contact(a, beside, 0), 5, 0, 9);
        pair = island.contact(a, b, Math.PI / 2);
        island.point(pair, 0, 0.5, 0);
        builder.build(0, 1);
        row = 1;
        assertThat(contacts.pair[row]).isEqualTo(pair);
        bent.begin();
    }

    private void boxes(double x, double y) {
        lay(Polygon.box(1, 1), Polygon.box(1, 1), x, y);
    }

    private void set(int slot, int column, double value) {
        motions.data[motions.offset(island.bodies, slot) + column] = value;
    }

    private double of(int column) {
        return contacts.data[row * PackedContacts.STRIDE + column];
    }

    private void carry(int column, double value) {
        contacts.data[row * PackedContacts.STRIDE + column] = value;
    }

    /** At the present places of both bodies, turned as far as they have turned. */
    @Test
    void contactIsMeasuredAtPresentPoses() {
        boxes(0.2, 1);
        set(a, Motions.DX, 3);
        set(a, Motions.DY, -2);
        set(b, Motions.DX, 3);
        set(b, Motions.DY, -1.75);
        set(b, Motions.TURN, Math.PI);
        fresh.measure(row, 1);
        assertThat(contacts.points[row]).isEqualTo(2);
        double left = island.pairs.pointX[2 * pair];
        double right = island.pairs.pointX[2 * pair + 1];
        assertThat(Math.min(left, right)).isCloseTo(3 - 0.3, within(ROUND_OFF));
        assertThat(Math.max(left, right)).isCloseTo(3 + 0.5, within(ROUND_OFF));
        assertThat(motions.gap(contacts, row, 0)).isCloseTo(0.25, within(ROUND_OFF));
        assertThat(motions.gap(contacts, row, 1)).isCloseTo(0.25, within(ROUND_OFF));
        fresh.recovery = 50;
        set(b, Motions.TURN, 0);
        set(a, Motions.TURN, Math.PI / 2);
        fresh.measure(row, 1);
        assertThat(motions.gap(contacts, row)).isCloseTo(0.25, within(ROUND_OFF));
        assertThat(of(PackedContacts.RECOVERY)).isEqualTo(50);
    }

    /** A point that persists keeps its impulses, whatever its index. */
    @Test
    void pointsKeepTheirImpulses() {
        boxes(0.2, 1);
        fresh.measure(row, 1);
        carry(PackedContacts.IMPULSE0, 2);
        carry(PackedContacts.IMPULSE1, 3);
        carry(PackedContacts.BEFORE0, 4);
        carry(PackedContacts.BEFORE1, 5);
        double first = island.pairs.pointX[2 * pair];
        set(b, Motions.DX, 0.01);
        fresh.measure(row, 1);
        boolean isFirst = Math.abs(island.pairs.pointX[2 * pair] - first) < 0.02;
        assertThat(of(PackedContacts.IMPULSE0)).isEqualTo(isFirst ? 2 : 3);
        assertThat(of(PackedContacts.IMPULSE1)).isEqualTo(isFirst ? 3 : 2);
        assertThat(of(PackedContacts.BEFORE0)).isEqualTo(isFirst ? 4 : 5);
        assertThat(of(PackedContacts.BEFORE1)).isEqualTo(isFirst ? 5 : 4);
    }

    /** Impulses follow the points that the manifold identifies. */
    @Test
    void impulsesGoWithTheirPoints() {
        lay(Polygon.box(1, 1), Polygon.box(4, 1), 0, 1);
        fresh.measure(row, 1);
        for (int column : new int[] {PackedContacts.IMPULSE0, PackedContacts.BEFORE0}) {
            carry(column, 2);
            carry(column + 1, 3);
        }
        set(b, Motions.TURN, Math.PI / 2);
        set(b, Motions.DY, 1.5);
        set(b, Motions.DX, 0.7);
        fresh.measure(row, 1);
        for (int point = 0; point < 2; point++) {
            int former = island.pairs.former[2 * pair + point];
            double carried = former == Pairs.NONE ? 0 : 2 + former;
            assertThat(of(PackedContacts.IMPULSE0 + point)).isEqualTo(carried);
            assertThat(of(PackedContacts.BEFORE0 + point)).isEqualTo(carried);
        }
    }

    /**
     * A second point within twice the way at the speed in the rest of the step, and A's width, 0.2
     * m.
     */
    @ParameterizedTest
    @CsvSource({"0, 0, 1", "1.2, 0, 1", "1.3, 0, 1", "1.65, 0, 2", "0, 1.65, 2"})
    void pointsMayBeAsFarAsBodiesReach(double vx, double vy, int points) {
        lay(Polygon.box(8, 0.2), Polygon.box(4, 0.3), 0, 0.25 + 2 * Math.sin(0.13));
        set(b, Motions.TURN, 0.13);
        set(b, Motions.VX, vx);
        set(b, Motions.VY, vy);
        // The other end is 4·sin 0.13 = 0.52 m up; 1.6 m/s reach it in 0.1 s.
        fresh.measure(row, 0.1);
        assertThat(contacts.points[row]).isEqualTo(points);
    }

    /** The ends of both bodies move at 1.6 m/s, whichever way they turn. */
    @ParameterizedTest
    @CsvSource({"0.82, 0, 2", "0.78, 0, 1", "0, 0.42, 2", "0, 0.38, 1", "-0.41, 0.21, 2"})
    void turningReachesAsWell(double spinB, double spinA, int points) {
        lay(Polygon.box(8, 0.2), Polygon.box(4, 0.3), 0, 0.25 + 2 * Math.sin(0.13));
        set(b, Motions.TURN, 0.13);
        set(b, Motions.SPIN, spinB);
        set(a, Motions.SPIN, spinA);
        fresh.measure(row, 0.1);
        assertThat(contacts.points[row]).isEqualTo(points);
    }

    /** A hundredth of a width, and twice the way at 1 + 2 m/s in a hundredth of a second. */
    @ParameterizedTest
    @CsvSource({"0.069, true", "0.071, false", "-1, true"})
    void contactsMayCloseAtTwiceTheirSpeed(double gap, boolean mayClose) {
        boxes(0, 1);
        carry(PackedContacts.GAP0, gap);
        set(b, Motions.VX, 1);
        set(a, Motions.VY, -2);
        assertThat(fresh.mayClose(row, 0.01)).isEqualTo(mayClose);
        set(b, Motions.VX, 0);
        set(a, Motions.VY, 0);
        set(a, Motions.VX, 1);
        set(b, Motions.VY, 2);
        assertThat(fresh.mayClose(row, 0.01)).isEqualTo(mayClose);
    }

    /**
     * A body that may come over the end of an edge has its gap beside it, less the motion of both.
     */
    @ParameterizedTest
    @CsvSource({"0.009, 0, true", "0.011, 0, false", "0.031, 0.01, true", "0.049, 0.01, false"})
    void awaitedContactsMayCloseBesideAnEdge(double beside, double way, boolean mayClose) {
        boxes(0, 1);
        island.data.hold(Need.ONE_SIDED);
        island.pairs.beside[pair] = beside;
        assertThat(fresh.isAwaited(row)).isFalse();
        island.pairs.points[pair] = 0;
        assertThat(fresh.isAwaited(row)).isTrue();
        set(a, Motions.DX, -way);
        set(b, Motions.DY, way);
        set(b, Motions.TURN, way / Math.sqrt(0.5));
        assertThat(fresh.mayClose(row, 0)).isEqualTo(mayClose);
    }

    /** A disc that joins 0.3 s after the substep's start is measured at its place there. */
    @Test
    void lateJoinersAreMeasuredWhereTheyJoin() {
        lay(new Circle(1), new Circle(1), -0.3, 2.1);
        set(b, Motions.VX, 2);
        island.bodies.pileTime[b] = 0.7;
        island.bodies.pileTime[a] = 0.2;
        contacts.joinsIn(row, 3);
        assertThat(fresh.measureJoining(2, 0.4, 0.6)).isFalse();
        assertThat(island.pairs.normalX[pair]).isCloseTo(0, within(1e-15));
        assertThat(fresh.measureJoining(3, 0.4, 0.6)).isTrue();
        double distance = Math.hypot(0.3, 2.1);
        assertThat(island.pairs.normalX[pair]).isCloseTo(0.3 / distance, within(ROUND_OFF));
        assertThat(island.pairs.separation[2 * pair]).isCloseTo(distance - 2, within(ROUND_OFF));
        // Then the gap is the measured one: the present gap less 0.6 m along n.
        motions.drift(0.3);
        assertThat(motions.gap(contacts, row, 0)).isCloseTo(distance - 2, within(ROUND_OFF));
        // A body that joined before the substep is measured at its present place.
        assertThat(fresh.measureJoining(3, 0.9, 0.1)).isTrue();
        assertThat(island.pairs.normalX[pair]).isCloseTo(0.3 / distance, within(ROUND_OFF));
        assertThat(fresh.measureJoining(4, 0.9, 0.1)).isFalse();
    }

    @Test
    void laterOfTwoJoinersCounts() {
        lay(new Circle(1), new Circle(1), 0, 2.1);
        set(a, Motions.VX, 2);
        island.bodies.pileTime[a] = 0.7;
        contacts.joinsIn(row, 0);
        assertThat(fresh.measureJoining(0, 0.6, 0.6)).isTrue();
        assertThat(island.pairs.normalX[pair])
                .isCloseTo(-0.2 / Math.hypot(0.2, 2.1), within(ROUND_OFF));
    }

    /** Turning outlines are measured before every part; those of the start are known. */
    @ParameterizedTest
    @CsvSource({
        "0, true, false",
        "1, true, true",
        "0, false, true",
        "2, true, false",
        "2, false, true"
    })
    void turningContactsAreMeasuredAgain(int substep, boolean isFirst, boolean isMeasured) {
        boxes(0.2, 1);
        contacts.firstSubstep[row] = 2;
        set(b, Motions.SPIN, 3);
        assertThat(bent.refresh(substep, isFirst, 0.1)).isTrue();
        assertThat(contacts.points[row]).isEqualTo(isMeasured ? 2 : 1);
        assertThat(bent.isAnyBent()).isTrue();
        bent.begin();
        assertThat(bent.isAnyBent()).isFalse();
    }

    @Test
    void straightContactsAreLeftAlone() {
        boxes(0.2, 1);
        assertThat(bent.refresh(1, true, 0.1)).isFalse();
        assertThat(bent.isAnyBent()).isFalse();
        assertThat(contacts.points[row]).isEqualTo(1);
        bent.bend(0.01, 0.01);
        assertThat(motions.gap(contacts, row)).isZero();
        assertThat(bent.untilNewPoints()).isEqualTo(Double.POSITIVE_INFINITY);
    }

    /** An edge that a body may come over is measured if the body may be there in the step. */
    @ParameterizedTest
    @CsvSource({"0.005, true", "0.5, false"})
    void awaitedContactsAreMeasuredIfTheyMayClose(double beside, boolean isMeasured) {
        boxes(0.2, 1);
        island.data.hold(Need.ONE_SIDED);
        island.pairs.beside[pair] = beside;
        island.pairs.points[pair] = 0;
        assertThat(bent.refresh(1, true, 0.1)).isEqualTo(isMeasured);
        assertThat(contacts.points[row]).isEqualTo(isMeasured ? 2 : 1);
        assertThat(bent.isAnyBent()).isFalse();
    }

    /** ½ω²h² of its arm; straight again after it stops turning. */
    @Test
    void turningBendsUntilItEnds() {
        boxes(0.2, 1);
        set(b, Motions.SPIN, 3);
        bent.refresh(1, true, 0.1);
        double before = motions.gap(contacts, row);
        bent.bend(0.01, 0.02);
        double bend = 3 * 0.01 * 3 * 0.01 / 2;
        assertThat(motions.gap(contacts, row)).isCloseTo(before + bend / 2, within(1e-9));
        double surface = contacts.surface[row];
        assertThat(surface).isNotZero();
        set(b, Motions.SPIN, 0);
        assertThat(bent.refresh(1, false, 0.1)).isFalse();
        bent.bend(0.01, 0.02);
        assertThat(contacts.surface[row]).isZero();
    }

    /** A disc that moves around another one: √(ρ² + s²) − ρ in the time in which gaps may close. */
    @Test
    void curvedContactsOpenInTheTimeInWhichTheyMayClose() {
        lay(new Circle(1), new Circle(1), 0, 2);
        set(b, Motions.VX, 3);
        assertThat(bent.refresh(1, true, 0.1)).isTrue();
        bent.bend(0.01, 0.02);
        double opens = Math.sqrt(4 + 0.06 * 0.06) - 2;
        assertThat(motions.gap(contacts, row)).isCloseTo(opens, within(ROUND_OFF));
        assertThat(bent.untilNewPoints()).isEqualTo(Double.POSITIVE_INFINITY);
    }

    /** Half of B is on A after 0.4 m more, at 4 m/s; see {@link CurvedRowsTest}. */
    @Test
    void boxThatComesOverAnEndHasOnePointForATime() {
        lay(Polygon.box(2, 1), Polygon.box(1, 1), -1.4, 1);
        set(b, Motions.VX, 4);
        set(b, Motions.TURN, 1e-4);
        assertThat(bent.refresh(1, true, 0.2)).isTrue();
        contacts.points[row] = 1;
        double until = bent.untilNewPoints();
        assertThat(until).isCloseTo(0.125, within(1e-3));
    }
}
