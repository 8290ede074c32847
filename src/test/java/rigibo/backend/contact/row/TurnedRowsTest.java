package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

import java.util.SplittableRandom;

/**
 * The bending of contacts by {@link TurningRows}, compared with places of material points after a
 * turn.
 */
class TurnedRowsTest {

    private final StoredIsland island = StoredIsland.turning();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final RowBuilder builder = island.builder;
    private final FreshRows fresh = island.fresh();
    private final TurningRows turning =
            new TurningRows(
                    island.data,
                    motions,
                    contacts,
                    fresh,
                    new Straightness(motions, Accuracy.GAME.withImpactTolerance(1e-3)));

    private int a;
    private int b;
    private int pair;

    private void lay(Convex shapeA, Convex shapeB, double by) {
        a = island.body(BodyDefinition.dynamic(shapeA));
        b = island.body(BodyDefinition.dynamic(shapeB).at(0.2, by));
        pair = island.contact(a, b, Math.PI / 2);
    }

    private void set(int slot, int column, double value) {
        motions.data[motions.offset(island.bodies, slot) + column] = value;
    }

    private double of(int slot, int column) {
        return motions.data[motions.offset(island.bodies, slot) + column];
    }

    private double of(int column) {
        return contacts.data[column];
    }

    private void throwAt(SplittableRandom random) {
        for (int slot : new int[] {a, b}) {
            for (int column = Motions.VX; column <= Motions.SPIN; column++) {
                set(slot, column, random.nextDouble(-1, 1));
            }
        }
    }

    /**
     * Gap after h of a point fixed to B, at a distance below its centre or its core's corner, from
     * the face of A: n·(p − cA) − a, where n turns with A. The linear part of the row is the gap
     * and its parting speed; the added part must be the rest, up to (ωh)³.
     */
    private void assertBentAsOnFaceOfA(double cornerX, double cornerY, double radius, double h) {
        double before = of(PackedContacts.GAP0);
        double linear = before + h * motions.parting(contacts, 0, 0);
        turning.bend(0, h);
        double added = of(PackedContacts.GAP0) - before - h * of(PackedContacts.NEARING);
        double turnA = h * of(a, Motions.SPIN);
        double turnB = h * of(b, Motions.SPIN);
        double x = island.bodies.x[b] + h * of(b, Motions.VX);
        double y = island.bodies.y[b] + h * of(b, Motions.VY);
        double px = x + Math.cos(turnB) * cornerX - Math.sin(turnB) * cornerY;
        double py = y + Math.sin(turnB) * cornerX + Math.cos(turnB) * cornerY;
        double nx = -Math.sin(turnA);
        double ny = Math.cos(turnA);
        double awayX = px - island.bodies.x[a] - h * of(a, Motions.VX);
        double awayY = py - island.bodies.y[a] - h * of(a, Motions.VY);
        double gap = nx * awayX + ny * awayY - 0.5 - radius;
        assertThat(added).isCloseTo(gap - linear, within(6 * h * h * h));
        assertThat(of(PackedContacts.GAP1)).isEqualTo(of(PackedContacts.GAP0));
    }

    private void bendOnFaceOfA(Convex shapeB, double by, double cornerX, double cornerY) {
        bendOnFaceOf(Polygon.box(4, 1), shapeB, by, cornerX, cornerY);
    }

    private void bendOnFaceOf(
            Convex shapeA, Convex shapeB, double by, double cornerX, double cornerY) {
        lay(shapeA, shapeB, by);
        island.pairs.faceOf[pair] = a;
        island.point(pair, 0.2 + cornerX, 0.5, 0);
        double radius = shapeB.outline().radius();
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 100; i++) {
            builder.build(0, 1);
            throwAt(random);
            assertBentAsOnFaceOfA(cornerX, cornerY, radius, 1e-3);
        }
    }

    @Test
    void sharpCornerOnAFaceThatTurns() {
        bendOnFaceOfA(Polygon.box(1, 2), 1.5, 0.5, -1);
    }

    @Test
    void discOnAFaceThatTurns() {
        bendOnFaceOfA(new Circle(0.5), 1, 0, 0);
    }

    @Test
    void roundEndOnAFaceThatTurns() {
        bendOnFaceOfA(new Capsule(0.7, 0.2), 0.7, 0.7, 0);
    }

    @Test
    void sharpCornerOnARoundedFaceThatTurns() {
        bendOnFaceOf(new Capsule(2, 0.5), Polygon.box(1, 2), 1.5, 0.5, -1);
    }

    /** Gaps do not depend on which of the bodies is A: each pair is stored both ways. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void faceMayBeThatOfB(int kind) {
        Convex[] shapes = {Polygon.box(1, 2), new Circle(0.5), new Capsule(0.7, 0.2)};
        double[] below = {1.5, 1, 0.7};
        double[] cornerX = {0.5, 0, 0.7};
        lay(Polygon.box(4, 1), shapes[kind], below[kind]);
        int other = island.contact(b, a, -Math.PI / 2);
        for (int each : new int[] {pair, other}) {
            island.pairs.faceOf[each] = a;
            island.point(each, 0.2 + cornerX[kind], 0.5, 0);
        }
        assertThat(island.pairs.bodyA[other]).isEqualTo(b);
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 50; i++) {
            builder.build(0, 1);
            throwAt(random);
            for (int row = 0; row < 2; row++) {
                turning.bend(row, 1e-3);
            }
            int at = PackedContacts.STRIDE;
            for (int column : new int[] {PackedContacts.GAP0, PackedContacts.NEARING}) {
                assertThat(contacts.data[at + column])
                        .isCloseTo(contacts.data[column], within(1e-12));
            }
            assertThat(contacts.surface[1]).isCloseTo(contacts.surface[0], within(1e-12));
        }
    }

    /**
     * Along the surface the corner of B moves with the cosine: r·(1 − cos φ) less than by its
     * speed, per second. Friction aims at the speed that keeps it in place, at the nearer point.
     */
    @ParameterizedTest
    @CsvSource({"0.01, -0.5", "-0.01, 0.5", "0, 0"})
    void cornerMayRunAheadByWhatKeepsItInPlace(double difference, double x) {
        lay(Polygon.box(4, 1), Polygon.box(1, 2), 1.5);
        island.point(pair, -0.3, 0.5, 0);
        island.point(pair, 0.7, 0.5, difference);
        builder.build(0, 1);
        contacts.running[0] = 0.25;
        double h = 1e-3;
        set(b, Motions.SPIN, 2);
        turning.bend(0, h);
        // The tangent points to the left; a corner to the left moves to the right by rφ²/2.
        double ahead = -x * 2 * 2 * h / 2;
        assertThat(contacts.surface[0]).isCloseTo(0.25 + ahead, within(1e-12));
        turning.straighten(0);
        assertThat(contacts.surface[0]).isEqualTo(0.25);
        assertThat(of(PackedContacts.NEARING)).isZero();
        set(a, Motions.SPIN, 2);
        set(b, Motions.SPIN, 0);
        turning.bend(0, h);
        double arm = difference == 0 ? 0.2 : x + 0.2;
        assertThat(contacts.surface[0]).isCloseTo(0.25 + arm * 2 * h, within(1e-12));
    }

    /** A turn counts up to 0.1 rad, in either direction. */
    @ParameterizedTest
    @ValueSource(doubles = {200, -200, 2000})
    void parabolaEndsAtATenthOfARadian(double spin) {
        lay(Polygon.box(4, 1), Polygon.box(1, 2), 1.5);
        island.point(pair, 0.2, 0.5, 0);
        builder.build(0, 1);
        set(b, Motions.SPIN, spin);
        turning.bend(0, 1e-3);
        assertThat(of(PackedContacts.GAP0)).isCloseTo(0.1 * 0.1 / 2, within(1e-15));
    }

    /** A centred disc has no corner that could rise. */
    @Test
    void discThatSpinsIsStraight() {
        lay(Polygon.box(4, 1), new Circle(1), 1.5);
        island.pairs.faceOf[pair] = b;
        island.point(pair, 0.2, 0.5, 0);
        builder.build(0, 1);
        set(b, Motions.SPIN, 50);
        turning.bend(0, 1e-3);
        assertThat(of(PackedContacts.GAP0)).isZero();
        assertThat(contacts.surface[0]).isZero();
        turning.begin(1);
        assertThat(turning.isTurning(0)).isFalse();
    }

    /** By a sagitta rφ²/2 of a hundredth of the tolerance in widths, among few bodies. */
    @ParameterizedTest
    @CsvSource({"0.0055, true", "0.0051, false", "-0.0055, true"})
    void outlinesTurnAboveASagitta(double turn, boolean isTurning) {
        lay(Polygon.box(1, 1), Polygon.box(1, 1), 1);
        island.point(pair, 0.2, 0.5, 0);
        builder.build(0, 1);
        // √½·φ²/2 = 10⁻⁵ at 5.32 mrad.
        for (int slot : new int[] {a, b}) {
            set(slot, Motions.SPIN, turn / 0.1);
            turning.begin(0.1);
            assertThat(turning.isTurning(0)).isEqualTo(isTurning);
            set(slot, Motions.SPIN, 0);
            turning.begin(0.1);
            assertThat(turning.isTurning(0)).isFalse();
            set(slot, Motions.TURN, turn);
            turning.begin(0.1);
            assertThat(turning.isTurning(0)).isEqualTo(isTurning);
            set(slot, Motions.TURN, 0);
        }
    }

    /** Only contacts of turning bodies bend; none if no body turns. */
    @Test
    void contactsOfStillBodiesStayStraight() {
        lay(Polygon.box(1, 1), Polygon.box(1, 1), 1);
        int c = island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 2));
        int other = island.contact(b, c, Math.PI / 2);
        int ground = island.body(BodyDefinition.fixed(Polygon.box(1, 1)).at(0, -1));
        int floor = island.contact(a, ground, -Math.PI / 2);
        for (int each : new int[] {pair, other, floor}) {
            island.point(each, 0.2, 0.5, 0);
        }
        builder.build(0, 1);
        set(c, Motions.SPIN, 1);
        turning.begin(0.1);
        for (int row = 0; row < 3; row++) {
            assertThat(turning.isTurning(row)).isEqualTo(contacts.pair[row] == other);
        }
        set(c, Motions.SPIN, 0);
        set(a, Motions.SPIN, 1);
        turning.begin(0.1);
        assertThat(turning.isTurning(0)).isTrue();
    }

    /** Contacts of bodies that turn by more than half of 0.1 rad, if they may close. */
    @ParameterizedTest
    @CsvSource({"51, 0.001, true", "49, 0.001, false", "-51, 0.001, true", "51, 30, false"})
    void farTurnedContactsAreMeasured(double spin, double gap, boolean isNew) {
        lay(Polygon.box(1, 1), Polygon.box(1, 1), 1.001);
        island.point(pair, 0.2, 0.5, gap);
        builder.build(0, 1);
        for (int slot : new int[] {a, b}) {
            set(slot, Motions.SPIN, spin);
            assertThat(turning.measureTurned(1e-3, 1e-3)).isEqualTo(isNew);
            assertThat(contacts.isNew[0]).isEqualTo(isNew);
            set(slot, Motions.SPIN, 0);
            assertThat(turning.measureTurned(1e-3, 1e-3)).isFalse();
            assertThat(contacts.isNew[0]).isFalse();
        }
        // Measured: two boxes, 1 mm apart, with two points.
        assertThat(contacts.points[0]).isEqualTo(isNew ? 2 : 1);
    }

    private double deviation(double spin, double speed, double dt) {
        return Math.sqrt(0.5) * spin * spin * dt * dt / 2 + speed * dt * spin * dt;
    }

    /**
     * A fiftieth of a width over four substeps, for more than four bodies; more for a tenth faster.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 4, -9, 20, 60, 400})
    void substepsAreAsManyAsTurningNeeds(double spin) {
        for (int i = 0; i < 6; i++) {
            island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).at(3 * i, 0));
        }
        island.bodies.spin[3] = spin;
        island.bodies.velocityX[3] = -1;
        island.bodies.velocityY[3] = 2;
        double wanted = deviation(Math.abs(spin), 3, 0.1) / 4 / 0.02;
        double more = Math.max(1, Math.min(16, wanted));
        assertThat(turning.substepsFor(0, 0.1, 4)).isEqualTo((int) Math.ceil(4 * more));
        assertThat(fresh.recovery).isCloseTo(25 + (more - 1) * 1e4, within(1e-6));
    }

    /** Among few bodies at most a twentieth of the turn from face to face in a substep. */
    @ParameterizedTest
    @CsvSource({"0.9, 4", "1.57, 4", "1.75, 5", "3.0, 8"})
    void fewBodiesTurnLessInASubstep(double spin, int substeps) {
        int box = island.body(BodyDefinition.dynamic(Polygon.box(1, 1)));
        island.bodies.spin[box] = -spin;
        // 4 corners: a turn of 2π/4·0.05 = 0.0785 rad a substep, of 0.2 s in all.
        assertThat(turning.substepsFor(0, 0.2, 4)).isEqualTo(substeps);
    }

    /** A disc has no corners and no face to turn to; a spinning disc does not count as turning. */
    @Test
    void discsNeedNoMoreSubsteps() {
        int disc = island.body(BodyDefinition.dynamic(new Circle(1)));
        island.bodies.spin[disc] = 100;
        island.bodies.velocityX[disc] = 100;
        assertThat(turning.substepsFor(0, 0.2, 4)).isEqualTo(4);
    }

    /** 4096 divided by the square of the number of bodies, if that is less than 16. */
    @Test
    void manyBodiesCostTooMuch() {
        for (int i = 0; i < 32; i++) {
            island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).at(3 * i, 0));
        }
        island.bodies.spin[3] = 1000;
        assertThat(turning.substepsFor(0, 0.1, 4)).isEqualTo(16);
    }
}
