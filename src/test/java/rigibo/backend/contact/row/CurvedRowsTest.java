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
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.storage.Pairs;

/** Round outlines that move around each other, and faces that slide on each other. */
class CurvedRowsTest {

    private static final double ROUND_OFF = 1e-13;
    private static final double TOLERANCE = 1e-3;
    private static final double FOREVER = Double.POSITIVE_INFINITY;
    private static final int ROW = 1;
    private static final double AX = 5;
    private static final double AY = 2;

    private final StoredIsland island = StoredIsland.turning();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final RowBuilder builder = island.builder;
    private final CurvedRows curved =
            new CurvedRows(
                    island.data,
                    motions,
                    contacts,
                    new Straightness(motions, Accuracy.GAME.withImpactTolerance(TOLERANCE)));

    private int a;
    private int b;
    private int pair;

    /** Makes B touch A with a normal at an angle; both are at their places. */
    private void touch(Convex shapeA, double ax, double ay, Convex shapeB, double bx, double by) {
        a = island.body(BodyDefinition.dynamic(shapeA).at(AX + ax, AY + ay));
        b = island.body(BodyDefinition.dynamic(shapeB).at(AX + bx, AY + by));
        layBeside();
    }

    /** Adds another contact of A, as the first row. */
    private void layBeside() {
        int beside = island.body(BodyDefinition.dynamic(Polygon.box(2, 2)).at(30, 0));
        island.point(island.contact(a, beside, 0.3), 9, 9, 9);
    }

    private void discs(double angle, double radiusA, double radiusB) {
        double apart = radiusA + radiusB;
        touch(
                new Circle(radiusA),
                3,
                4,
                new Circle(radiusB),
                3 + apart * Math.cos(angle),
                4 + apart * Math.sin(angle));
        pair = island.contact(a, b, angle);
        double x = 3 + radiusA * Math.cos(angle);
        island.point(pair, AX + x, AY + 4 + radiusA * Math.sin(angle), 0);
        builder.build(0, 1);
    }

    private void set(int slot, int column, double value) {
        motions.data[motions.offset(island.bodies, slot) + column] = value;
    }

    private double gap0() {
        return contacts.data[ROW * PackedContacts.STRIDE + PackedContacts.GAP0];
    }

    /**
     * Moving straight along the common tangent, they have the distance √(ρ² + s²), and the gap
     * widens by that less ρ, at any spin. Motion along the normal does not count.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.8, -2.2})
    void discsThatGoStraightOnPartByPythagoras(double angle) {
        discs(angle, 0.5, 1);
        double tx = -Math.sin(angle);
        double ty = Math.cos(angle);
        set(a, Motions.VX, 2 * tx + 7 * ty);
        set(a, Motions.VY, 2 * ty - 7 * tx);
        set(b, Motions.VX, -tx);
        set(b, Motions.VY, -ty);
        set(b, Motions.SPIN, 9);
        set(a, Motions.SPIN, -5);
        curved.bend(ROW, 0.1);
        double parted = Math.sqrt(1.5 * 1.5 + 0.3 * 0.3) - 1.5;
        assertThat(gap0()).isCloseTo(parted, within(ROUND_OFF));
        int at = ROW * PackedContacts.STRIDE;
        assertThat(contacts.data[at + PackedContacts.GAP1]).isCloseTo(parted, within(ROUND_OFF));
    }

    /** A face has no radius, nor have two corners that meet. */
    @Test
    void facesAndCornersAreNotBent() {
        touch(Polygon.box(1, 1), 0, 0, Polygon.box(1, 1), 1, 1);
        pair = island.contact(a, b, 0.8);
        island.point(pair, AX + 0.5, AY + 0.5, 0);
        builder.build(0, 1);
        set(b, Motions.VX, 2);
        curved.bend(ROW, 0.1);
        assertThat(gap0()).isZero();
    }

    @Test
    void roundOutlineOnAFaceIsNotBent() {
        discs(0, 1, 1);
        island.pairs.faceOf[pair] = a;
        set(b, Motions.VY, 2);
        curved.bend(ROW, 0.1);
        assertThat(gap0()).isZero();
    }

    /**
     * A capsule's end rolls about the end of its core, which does not slide along the disc if the
     * body turns about it. At an arm of −1 + 0.3 from the centre, spin ω moves it by 0.7·ω.
     */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void endOfTheCoreIsWhatMoves(boolean isFirst) {
        Capsule pill = new Capsule(0.7, 0.3);
        BodyDefinition upright = BodyDefinition.dynamic(pill).angle(Math.PI / 2);
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.5));
        double angle = Math.PI / 2;
        a = island.body(isFirst ? upright : disc);
        b = island.body((isFirst ? disc : upright).at(0, 1.5));
        layBeside();
        pair = island.contact(a, b, angle);
        island.point(pair, 0, isFirst ? 1 : 0.5, 0);
        builder.build(0, 1);
        int turning = isFirst ? a : b;
        set(turning, Motions.SPIN, 2);
        // The end moves by 0.7·ω to the left or right, and the body moves along.
        set(turning, Motions.VX, isFirst ? 1.4 : -1.4);
        curved.bend(ROW, 0.1);
        assertThat(gap0()).isCloseTo(0, within(ROUND_OFF));
        set(turning, Motions.VX, isFirst ? 2.4 : -2.4);
        curved.bend(ROW, 0.1);
        assertThat(gap0()).isCloseTo(Math.sqrt(0.64 + 0.01) - 0.8, within(ROUND_OFF));
    }

    /** √(ρ² + s²) − ρ above a hundredth of the tolerance in widths, for a width of 1 m. */
    @ParameterizedTest
    @CsvSource({"0.0064, true", "0.0062, false", "-0.0064, true"})
    void fewDiscsCurveEarly(double way, boolean isCurved) {
        discs(0, 0.5, 1.5);
        // s²/(2·2) = 10⁻⁵ at s = 6.32 mm.
        set(b, Motions.VY, way);
        assertThat(curved.isCurved(ROW, 1)).isEqualTo(isCurved);
        assertThat(curved.isCurved(ROW, 0)).isFalse();
        // The way since the step's start counts, too.
        set(b, Motions.VY, 0);
        set(b, Motions.DY, way);
        assertThat(curved.isCurved(ROW, 1)).isEqualTo(isCurved);
    }

    @ParameterizedTest
    @CsvSource({"0.0634, true", "0.0631, false"})
    void manyDiscsCurveLater(double way, boolean isCurved) {
        discs(0, 0.5, 1.5);
        motions.count = 9;
        set(b, Motions.VY, way);
        assertThat(curved.isCurved(ROW, 1)).isEqualTo(isCurved);
    }

    /** Without impacts in time order, few bodies count like many. */
    @Test
    void splitImpactsDoNotFollowClosely() {
        Straightness straight =
                new Straightness(motions, Accuracy.GAME.withImpacts(ImpactMode.SPLIT));
        assertThat(straight.unseen()).isEqualTo(1e-4);
        assertThat(straight.follows).isFalse();
        straight = new Straightness(motions, Accuracy.GAME);
        assertThat(straight.follows).isTrue();
        assertThat(straight.unseen()).isCloseTo(1e-6, within(1e-20));
        motions.count = 9;
        assertThat(straight.unseen()).isEqualTo(1e-4);
    }

    /** Two corners curve only among few bodies. */
    @Test
    void cornersCurveAmongFew() {
        touch(Polygon.box(1, 1), 0, 0, Polygon.box(1, 1), 1, 1);
        pair = island.contact(a, b, Math.PI / 4);
        island.point(pair, AX + 0.5, AY + 0.5, 0);
        builder.build(0, 1);
        set(b, Motions.VX, 0.1);
        assertThat(curved.isCurved(ROW, 1)).isTrue();
        motions.count = 9;
        assertThat(curved.isCurved(ROW, 1)).isFalse();
    }

    /**
     * A box of half the length slides along the top of another, with its left end 0.1 m from A's.
     */
    private void faces(double x) {
        touch(Polygon.box(2, 1), 0, 0, Polygon.box(1, 1), x, 1);
        pair = island.contact(a, b, Math.PI / 2);
        island.pairs.faceOf[pair] = a;
        island.point(pair, AX + 0.5, AY + 0.5, 0);
        builder.build(0, 1);
        contacts.points[ROW] = 1;
    }

    /**
     * Corners at ±0.5 of B, at x = −0.4: their distances from the ends of A's face at ±1 are 0.1,
     * 1.1, 0.9 … m.
     */
    @ParameterizedTest
    @CsvSource({
        "-0.4, 0.11, true",
        "-0.4, 0.09, false",
        "0.4, -0.11, true",
        "0.4, 0.09, false",
        "-1.4, 0.11, true",
        "-1.4, 0.09, false",
        "1.4, 0.11, true",
        "1.4, 0.09, false"
    })
    void cornersThatReachTheEndOfAFaceCurve(double x, double way, boolean isCurved) {
        faces(x);
        set(b, Motions.VX, way);
        assertThat(curved.isCurved(ROW, 1)).isEqualTo(isCurved);
        motions.count = 9;
        assertThat(curved.isCurved(ROW, 1)).isFalse();
    }

    /** Corners reach the ends of a face in the same way if both bodies are turned. */
    @ParameterizedTest
    @CsvSource({"0.11, true", "0.09, false"})
    void facesMayBeTurned(double way, boolean isCurved) {
        double turn = 0.7;
        double cos = Math.cos(turn);
        double sin = Math.sin(turn);
        a = island.body(BodyDefinition.dynamic(Polygon.box(2, 1)).angle(turn));
        b =
                island.body(
                        BodyDefinition.dynamic(Polygon.box(1, 1))
                                .angle(turn)
                                .at(-0.4 * cos - sin, -0.4 * sin + cos));
        layBeside();
        pair = island.contact(a, b, Math.PI / 2 + turn);
        island.pairs.faceOf[pair] = b;
        island.point(pair, 0, 0.5, 0);
        builder.build(0, 1);
        set(b, Motions.VX, way * cos);
        set(b, Motions.VY, way * sin);
        assertThat(curved.isCurved(ROW, 1)).isEqualTo(isCurved);
    }

    /** The lowest point of a disc is its centre, on a face that ends 0.3 m from it. */
    @ParameterizedTest
    @CsvSource({"0.31, true", "0.29, false"})
    void discRollsOffTheEndOfAFace(double way, boolean isCurved) {
        touch(Polygon.box(2, 1), 0, 0, new Circle(0.5), 0.7, 1);
        pair = island.contact(a, b, Math.PI / 2);
        island.pairs.faceOf[pair] = a;
        island.point(pair, AX + 0.7, AY + 0.5, 0);
        builder.build(0, 1);
        set(b, Motions.VX, way);
        assertThat(curved.isCurved(ROW, 1)).isEqualTo(isCurved);
    }

    /** A disc that turns with its face keeps its place there, whichever of them is A. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void discThatTurnsWithAFaceStaysOnIt(boolean isFaceOfA) {
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(2, 1));
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.5)).at(0.7, 1);
        a = island.body(isFaceOfA ? box : disc);
        b = island.body(isFaceOfA ? disc : box);
        layBeside();
        pair = island.contact(a, b, isFaceOfA ? Math.PI / 2 : -Math.PI / 2);
        island.pairs.faceOf[pair] = isFaceOfA ? a : b;
        island.point(pair, 0.7, 0.5, 0);
        builder.build(0, 1);
        double spin = 2;
        set(a, Motions.SPIN, spin);
        set(b, Motions.SPIN, spin);
        int rider = isFaceOfA ? b : a;
        set(rider, Motions.VX, -spin);
        set(rider, Motions.VY, 0.7 * spin);
        assertThat(curved.isCurved(ROW, 1)).isFalse();
        // The end is 0.3 m away: 0.31 m are too many.
        set(rider, Motions.VX, 0.31 - spin);
        assertThat(curved.isCurved(ROW, 1)).isTrue();
    }

    /** At 1.4 m from A's middle a tenth of B is over A: after 0.5 m more it is half. */
    @ParameterizedTest
    @CsvSource({"-1.4, 2, 0.25", "1.4, -2, 0.25", "-1.4, -2, Infinity", "-0.9, 2, Infinity"})
    void secondPointComesWithHalfOfAFace(double x, double speed, double time) {
        faces(x);
        set(b, Motions.VX, speed);
        assertThat(curved.untilNewPoint(ROW)).isCloseTo(time, within(ROUND_OFF));
        // The slide since the step's start counts, too: 0.6 m farther, more than half is over A.
        set(b, Motions.DX, speed > 0 ? 0.6 : -0.6);
        assertThat(curved.untilNewPoint(ROW)).isEqualTo(FOREVER);
    }

    @Test
    void onlyOnePointOfATouchingFaceMayBeFollowedByAnother() {
        faces(-1.4);
        set(b, Motions.VX, 2);
        contacts.points[ROW] = 2;
        assertThat(curved.untilNewPoint(ROW)).isEqualTo(FOREVER);
        contacts.points[ROW] = 1;
        set(b, Motions.DY, 1.1e-3);
        assertThat(curved.untilNewPoint(ROW)).isEqualTo(FOREVER);
        set(b, Motions.DY, 0.9e-3);
        assertThat(curved.untilNewPoint(ROW)).isCloseTo(0.25, within(ROUND_OFF));
        island.pairs.faceOf[pair] = Pairs.NONE;
        assertThat(curved.untilNewPoint(ROW)).isEqualTo(FOREVER);
    }

    /** A disc has no length, of which half could be over a face. */
    @Test
    void discHasNoSecondPoint() {
        touch(Polygon.box(2, 1), 0, 0, new Circle(0.5), -0.99, 1);
        pair = island.contact(a, b, Math.PI / 2);
        island.pairs.faceOf[pair] = a;
        island.point(pair, AX - 0.99, AY + 0.5, 0);
        builder.build(0, 1);
        set(b, Motions.VX, 2);
        assertThat(curved.untilNewPoint(ROW)).isEqualTo(FOREVER);
    }
}
