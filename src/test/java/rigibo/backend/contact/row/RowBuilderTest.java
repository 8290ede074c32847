package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.SplittableRandom;

/**
 * Rows of contacts with any normal, points and bodies, compared with velocities of material points.
 */
class RowBuilderTest {

    /** Round-off of numbers up to 10. */
    private static final double ROUND_OFF = 1e-13;

    private static final double KICK = 0.01;

    private final StoredIsland island = StoredIsland.turning();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final RowBuilder builder = island.builder;

    private double of(int row, int column) {
        return contacts.data[row * PackedContacts.STRIDE + column];
    }

    private int box(double x, double y, double mass) {
        return island.body(BodyDefinition.dynamic(Polygon.box(1, 2)).at(x, y).mass(mass));
    }

    private void pack() {
        builder.build(0, KICK);
    }

    /** Velocity along (nx, ny) of the material point of a packed body at a place. */
    private double along(int slot, double px, double py, double nx, double ny) {
        int at = motions.offset(island.bodies, slot);
        double spin = motions.data[at + Motions.SPIN];
        double x = island.bodies.x[slot] + motions.data[at + Motions.DX];
        double y = island.bodies.y[slot] + motions.data[at + Motions.DY];
        return nx * (motions.data[at + Motions.VX] - spin * (py - y))
                + ny * (motions.data[at + Motions.VY] + spin * (px - x));
    }

    private void move(SplittableRandom random, int from, int to) {
        for (int entry = 1; entry < motions.count; entry++) {
            for (int column = from; column <= to; column++) {
                motions.data[entry * Motions.STRIDE + column] = random.nextDouble(-1, 1);
            }
        }
    }

    /**
     * n·(vB + ωB × rB − vA − ωA × rA) at both points, and likewise along the tangent at the nearer
     * one.
     */
    @Test
    void speedsAreThoseOfMaterialPoints() {
        SplittableRandom random = new SplittableRandom(1);
        int a = box(0.3, -0.2, 2);
        int b = box(1.1, 2.3, 0.7);
        for (int i = 0; i < 40; i++) {
            double angle = random.nextDouble(-3, 3);
            island.data.islands.pairStart[1] = 0;
            int pair = island.contact(a, b, angle);
            double[] px = {random.nextDouble(-1, 1), random.nextDouble(1, 2)};
            double[] py = {random.nextDouble(-1, 1), random.nextDouble(1, 2)};
            double[] gap = {random.nextDouble(-0.01, 0.01), random.nextDouble(-0.01, 0.01)};
            island.point(pair, px[0], py[0], gap[0]);
            island.point(pair, px[1], py[1], gap[1]);
            pack();
            assertThat(contacts.count).isEqualTo(1);
            assertThat(contacts.points[0]).isEqualTo(2);
            move(random, Motions.VX, Motions.SPIN);
            double nx = Math.cos(angle);
            double ny = Math.sin(angle);
            for (int k = 0; k < 2; k++) {
                double speed = along(b, px[k], py[k], nx, ny) - along(a, px[k], py[k], nx, ny);
                assertThat(motions.parting(contacts, 0, k)).isCloseTo(speed, within(ROUND_OFF));
                assertThat(motions.gap(contacts, 0, k)).isEqualTo(gap[k]);
            }
            int near = gap[0] < gap[1] ? 0 : 1;
            double slide =
                    along(b, px[near], py[near], -ny, nx) - along(a, px[near], py[near], -ny, nx);
            double armA = of(0, PackedContacts.LEVER_TA);
            double armB = of(0, PackedContacts.LEVER_TB);
            assertThat(motions.slide(contacts, 0, armA, armB)).isCloseTo(slide, within(ROUND_OFF));
            assertMassesInvert();
        }
    }

    /**
     * K is the response of both points to unit impulses, with 10⁻¹⁰ of the first more; M is K⁻¹.
     */
    private void assertMassesInvert() {
        double k00 = response(0, 0);
        double k01 = response(0, 1);
        double k11 = response(1, 1);
        double give = 1e-10 * k00;
        assertThat(of(0, PackedContacts.GIVE)).isCloseTo(give, within(1e-13 * give));
        assertThat(of(0, PackedContacts.K00)).isCloseTo(k00 + give, within(ROUND_OFF));
        assertThat(of(0, PackedContacts.K01)).isCloseTo(k01, within(ROUND_OFF));
        assertThat(of(0, PackedContacts.K11)).isCloseTo(k11 + give, within(ROUND_OFF));
        double m00 = of(0, PackedContacts.M00);
        double m01 = of(0, PackedContacts.M01);
        double m11 = of(0, PackedContacts.M11);
        // The condition of these matrices is below 10⁴.
        assertThat((k00 + give) * m00 + k01 * m01).isCloseTo(1, within(1e-11));
        assertThat((k00 + give) * m01 + k01 * m11).isCloseTo(0, within(1e-11));
        assertThat(k01 * m01 + (k11 + give) * m11).isCloseTo(1, within(1e-11));
    }

    /** Speed of one point by an impulse of 1 N·s at another. */
    private double response(int point, int other) {
        DenseRows dense = new DenseRows(packed());
        return dense.response(0, point, 0, other);
    }

    private PackedIsland packed() {
        PackedIsland copy = new PackedIsland();
        copy.motions.data = motions.data;
        copy.motions.count = motions.count;
        copy.contacts.data = contacts.data;
        copy.contacts.bodyA = contacts.bodyA;
        copy.contacts.bodyB = contacts.bodyB;
        copy.contacts.count = contacts.count;
        return copy;
    }

    /** Half way between two points of the same depth, or at a single one. */
    @Test
    void frictionActsAtTheNearerPoint() {
        int a = box(0, 0, 1);
        int b = box(0, 2, 1);
        int pair = island.contact(a, b, 0);
        island.point(pair, 0.1, 0.5, 0.01);
        assertThat(RowBuilder.rubsAt(island.pairs, pair, 1, 0)).isEqualTo(0.1);
        island.point(pair, 0.3, 0.7, 0.01);
        assertThat(RowBuilder.rubsAt(island.pairs, pair, 1, 0)).isEqualTo(0.2);
        assertThat(RowBuilder.rubsAt(island.pairs, pair, 0, 1)).isEqualTo(0.6, within(1e-15));
        island.pairs.separation[2 * pair + 1] = 0.02;
        assertThat(RowBuilder.rubsAt(island.pairs, pair, 1, 0)).isEqualTo(0.1);
        assertThat(RowBuilder.rubsAt(island.pairs, pair, 0, 1)).isEqualTo(0.5);
        island.pairs.separation[2 * pair + 1] = 0;
        assertThat(RowBuilder.rubsAt(island.pairs, pair, 1, 0)).isEqualTo(0.3);
    }

    /**
     * Points at ±x of a body on the ground: k00 = 1/m + x²/I and k01 = 1/m − x²/I. The determinant
     * is 4·x²/(m·I), which is 10⁻⁴ of k00·k11 at x = 0.005·√(I/m), to within x².
     */
    @ParameterizedTest
    @CsvSource({"0.0051, 2", "0.0049, 1"})
    void pointsTooCloseCountAsOne(double x, int points) {
        int ground = island.body(BodyDefinition.fixed(Polygon.box(9, 1)));
        int b = island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 1).mass(2).inertia(2));
        int pair = island.contact(ground, b, Math.PI / 2);
        island.point(pair, -x, 0.5, 0);
        island.point(pair, x, 0.5, 0);
        pack();
        assertThat(contacts.points[0]).isEqualTo(points);
        assertThat(contacts.groundStart).isZero();
        assertThat(contacts.bodyA[0]).isZero();
    }

    /** Of the two points the deeper one remains, whatever their order. */
    @ParameterizedTest
    @CsvSource({"-0.02, -0.01, -0.001", "-0.01, -0.02, 0.002", "-0.01, -0.01, -0.001"})
    void deeperOfTwoPointsRemains(double gap0, double gap1, double x) {
        int a = box(0.5, 0, 1);
        int b = box(0, 2, 4);
        int pair = island.contact(a, b, Math.PI / 2);
        island.point(pair, -0.001, 1, gap0);
        island.point(pair, 0.002, 1, gap1);
        island.pairs.normalForce[2 * pair] = 3;
        island.pairs.normalForce[2 * pair + 1] = 4;
        island.pairs.load[2 * pair] = 5;
        island.pairs.load[2 * pair + 1] = 6;
        pack();
        assertThat(contacts.points[0]).isEqualTo(1);
        assertThat(motions.gap(contacts, 0)).isEqualTo(-Math.max(-gap0, -gap1));
        double k = 1 + 0.25 + sq(x - 0.5) / inertia(a) + sq(x) / inertia(b);
        assertThat(of(0, PackedContacts.LEVER_A0)).isCloseTo(x - 0.5, within(1e-15));
        assertThat(of(0, PackedContacts.LEVER_B0)).isCloseTo(x, within(1e-15));
        assertThat(of(0, PackedContacts.K00)).isCloseTo(k * (1 + 1e-10), within(1e-12));
        assertThat(of(0, PackedContacts.M00)).isCloseTo(1 / (k * (1 + 1e-10)), within(1e-12));
        assertThat(of(0, PackedContacts.IMPULSE0)).isCloseTo(7 * KICK, within(1e-16));
        assertThat(of(0, PackedContacts.IMPULSE1)).isZero();
        assertThat(of(0, PackedContacts.LOAD0)).isEqualTo(11);
        assertThat(of(0, PackedContacts.LOAD1)).isZero();
    }

    private static double sq(double x) {
        return x * x;
    }

    private double inertia(int slot) {
        return 1 / island.bodies.inverseInertia[slot];
    }

    /** Forces times the length of the kick, each at its own point. */
    @Test
    void kickBeginsWithTheForcesOfTheLastStep() {
        int a = box(0, 0, 1);
        int b = box(0, 2, 4);
        int far = island.contact(a, b, 0);
        int pair = island.contact(a, b, Math.PI / 2);
        island.point(pair, -0.5, 1, -1e-3);
        island.point(pair, 0.5, 1, -2e-3);
        island.pairs.normalForce[2 * pair] = 3;
        island.pairs.normalForce[2 * pair + 1] = 4;
        island.pairs.load[2 * pair] = 5;
        island.pairs.load[2 * pair + 1] = 6;
        pack();
        assertThat(contacts.pair[0]).isEqualTo(far);
        assertThat(contacts.pair[1]).isEqualTo(pair);
        assertThat(contacts.groundStart).isEqualTo(2);
        assertThat(of(1, PackedContacts.IMPULSE0)).isEqualTo(3 * KICK);
        assertThat(of(1, PackedContacts.IMPULSE1)).isEqualTo(4 * KICK);
        assertThat(of(1, PackedContacts.LOAD0)).isEqualTo(5);
        assertThat(of(1, PackedContacts.LOAD1)).isEqualTo(6);
        assertThat(of(1, PackedContacts.WIDTH)).isEqualTo(1);
        assertThat(of(1, PackedContacts.RECOVERY)).isEqualTo(25);
        // A contact without points counts as one that is very far away.
        assertThat(contacts.points[0]).isEqualTo(1);
        assertThat(motions.gap(contacts, 0)).isEqualTo(1e9);
    }

    @Test
    void bodiesArePackedWithTheirTurning() {
        int a = island.body(BodyDefinition.dynamic(Polygon.box(1, 1)).velocity(1, 2).spin(3));
        int driven = island.body(BodyDefinition.kinematic(Polygon.box(1, 1)).spin(5));
        int still = island.body(BodyDefinition.kinematic(Polygon.box(1, 1)));
        builder.packBodies(0);
        assertThat(motions.count).isEqualTo(2);
        assertThat(motions.data[Motions.STRIDE + Motions.SPIN]).isEqualTo(3);
        assertThat(motions.data[Motions.STRIDE + Motions.INVERSE_INERTIA])
                .isEqualTo(1 / inertia(a));
        motions.data[Motions.STRIDE + Motions.SPIN] = 7;
        assertThat(builder.offset(a)).isEqualTo(Motions.STRIDE);
        assertThat(motions.data[Motions.STRIDE + Motions.SPIN]).isEqualTo(7);
        assertThat(builder.offset(driven)).isEqualTo(2 * Motions.STRIDE);
        assertThat(motions.data[2 * Motions.STRIDE + Motions.SPIN]).isEqualTo(5);
        assertThat(builder.offset(still)).isZero();
        assertThat(motions.count).isEqualTo(3);
    }

    /** A twentieth of the smaller width. */
    @ParameterizedTest
    @CsvSource({"-0.051, true", "-0.049, false", "0.06, false"})
    void contactIsCrushedByDeepOverlap(double gap, boolean isCrushed) {
        int a = box(0, 0, 1);
        int ground = island.body(BodyDefinition.fixed(Polygon.box(9, 9)).at(0, 5));
        int pair = island.contact(a, ground, Math.PI / 2);
        island.point(pair, 0, 1, gap);
        pack();
        assertThat(island.pairs.crushed[pair]).isEqualTo(isCrushed);
        assertThat(contacts.isAnyCrushed).isEqualTo(isCrushed);
    }

    /** The thinner body need not be movable. */
    @Test
    void thinWallIsCrushedToo() {
        int a = box(0, 0, 1);
        int wall = island.body(BodyDefinition.fixed(Polygon.box(9, 0.1)).at(0, 1));
        int pair = island.contact(a, wall, Math.PI / 2);
        assertThat(RowBuilder.isCrushed(island.bodies, island.pairs, pair, -0.006)).isTrue();
        assertThat(RowBuilder.isCrushed(island.bodies, island.pairs, pair, -0.004)).isFalse();
    }

    /** By 1 % of the speed that an impulse gives the whole island. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void contactsOfDrivenBodiesGive(boolean isFirst) {
        BodyDefinition press = BodyDefinition.kinematic(Polygon.box(2, 2)).velocity(0, 1);
        int driven = isFirst ? island.body(press) : -1;
        int a = box(0, 2, 3);
        box(5, 2, 1);
        driven = isFirst ? driven : island.body(press);
        int pair =
                isFirst
                        ? island.contact(driven, a, Math.PI / 2)
                        : island.contact(a, driven, -Math.PI / 2);
        island.point(pair, 0.1, 1, 0);
        pack();
        double k = 1 / 3.0 + 0.01 / inertia(a);
        double give = 1e-10 * k + 0.01 / 4;
        assertThat(of(0, PackedContacts.GIVE)).isCloseTo(give, within(1e-15));
        assertThat(of(0, PackedContacts.K00)).isCloseTo(k + give, within(ROUND_OFF));
        assertThat(motions.count).isEqualTo(4);
        // The driven body presses along at its own velocity.
        assertThat(motions.parting(contacts, 0, 0)).isCloseTo(-1, within(ROUND_OFF));
    }

    /** A disc lies on a disc that has moved up by 1 m; the gap is as measured there. */
    @Test
    void gapsOfRewrittenRowsAreThoseOfTheirPresentPlaces() {
        SplittableRandom random = new SplittableRandom(2);
        int a = box(0, 0, 1);
        int b = box(0.4, 2, 2);
        int pair = island.contact(a, b, 1);
        island.point(pair, 0, 1, -1e-3);
        island.point(pair, 0.5, 0.9, -2e-3);
        pack();
        for (int i = 0; i < 20; i++) {
            move(random, Motions.DX, Motions.TURN);
            move(random, Motions.VX, Motions.SPIN);
            island.pairs.normalX[pair] = Math.cos(i);
            island.pairs.normalY[pair] = Math.sin(i);
            for (int k = 0; k < 2; k++) {
                island.pairs.pointX[2 * pair + k] = random.nextDouble(-1, 1);
                island.pairs.pointY[2 * pair + k] = random.nextDouble(2 * k, 2 * k + 1);
                island.pairs.separation[2 * pair + k] = random.nextDouble(-1, 1);
            }
            builder.rewrite(0);
            for (int k = 0; k < contacts.points[0]; k++) {
                double px = island.pairs.pointX[2 * pair + k];
                double py = island.pairs.pointY[2 * pair + k];
                double nx = Math.cos(i);
                double ny = Math.sin(i);
                double speed = along(b, px, py, nx, ny) - along(a, px, py, nx, ny);
                assertThat(motions.parting(contacts, 0, k)).isCloseTo(speed, within(ROUND_OFF));
                assertThat(motions.gap(contacts, 0, k))
                        .isCloseTo(island.pairs.separation[2 * pair + k], within(ROUND_OFF));
            }
        }
        island.pairs.points[pair] = 0;
        builder.rewrite(0);
        assertThat(contacts.points[0]).isEqualTo(1);
        assertThat(of(0, PackedContacts.GAP0)).isEqualTo(1e9);
    }

    /** The load of the second point is added to the remaining one. */
    @Test
    void impulsesAreNotLostWhenTwoPointsBecomeOne() {
        int a = box(0, 0, 1);
        int b = box(0, 2, 2);
        int pair = island.contact(a, b, Math.PI / 2);
        island.point(pair, -0.5, 1, 0);
        island.point(pair, 0.5, 1, 0);
        pack();
        int[] pairs = {
            PackedContacts.IMPULSE0, PackedContacts.LOAD0, PackedContacts.BEFORE0,
        };
        for (int first : pairs) {
            contacts.data[first] = 2;
            contacts.data[first + 1] = 3;
        }
        builder.rewrite(0);
        assertThat(of(0, PackedContacts.IMPULSE1)).isEqualTo(3);
        island.pairs.pointX[2 * pair] = 0.4999;
        builder.rewrite(0);
        assertThat(contacts.points[0]).isEqualTo(1);
        for (int first : pairs) {
            assertThat(contacts.data[first]).isEqualTo(5);
            assertThat(contacts.data[first + 1]).isZero();
        }
    }

    /** Without rotation there is one row, at the nearer point, without levers. */
    @Test
    void bodiesThatDoNotTurnHaveOneRow() {
        StoredIsland flat = new StoredIsland(Effects.of(new Contacts()));
        RowBuilder plain = flat.builder;
        int a = flat.body(BodyDefinition.dynamic(Polygon.box(1, 1)).mass(2));
        int b = flat.body(BodyDefinition.dynamic(new Circle(1)).at(0, 1.5).mass(4));
        int pair = flat.contact(a, b, 0.3);
        flat.point(pair, -0.5, 0.5, 1e-3);
        flat.point(pair, 0.5, 0.5, -2e-3);
        flat.pairs.normalForce[2 * pair] = 3;
        flat.pairs.normalForce[2 * pair + 1] = 4;
        plain.build(0, KICK);
        plain.packBodies(0);
        assertThat(plain.offset(b)).isEqualTo(2 * Motions.STRIDE);
        assertThat(flat.contacts.points[0]).isEqualTo(1);
        assertThat(flat.contacts.data[PackedContacts.NX]).isEqualTo(Math.cos(0.3));
        assertThat(flat.contacts.data[PackedContacts.NY]).isEqualTo(Math.sin(0.3));
        assertThat(flat.contacts.data[PackedContacts.GAP0]).isEqualTo(-2e-3);
        assertThat(flat.contacts.data[PackedContacts.LEVER_A0]).isZero();
        double k = 0.75 * (1 + 1e-10);
        assertThat(flat.contacts.data[PackedContacts.K00]).isCloseTo(k, within(1e-15));
        assertThat(flat.contacts.data[PackedContacts.M00]).isCloseTo(1 / k, within(1e-15));
        assertThat(flat.contacts.data[PackedContacts.IMPULSE0]).isCloseTo(7 * KICK, within(1e-16));
    }
}
