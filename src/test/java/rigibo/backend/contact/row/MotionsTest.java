package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;

import java.util.Arrays;
import java.util.SplittableRandom;

/** Random packed bodies and contacts, compared with their written-out rows. */
class MotionsTest {

    private static final double ROUND_OFF = 1e-13;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final DenseRows dense = new DenseRows(island);
    private final Bodies bodies = new Bodies(Effects.of(new Contacts(), new Rotation()));

    private void place(SplittableRandom random) {
        for (int entry = 1; entry < motions.count; entry++) {
            for (int column = Motions.DX; column <= Motions.TURN; column++) {
                motions.data[entry * Motions.STRIDE + column] = random.nextDouble(-1, 1);
            }
        }
    }

    /** Gaps and speeds of both points and of the tangent, and responses: rows times columns. */
    @Test
    void gapsAndSpeedsFollowTheirRows() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 200; i++) {
            island.bodies(random, 3);
            place(random);
            int row = island.contact(random, i % 2 == 0 ? 0 : 1, 2);
            double[] d = contacts.data;
            int at = row * PackedContacts.STRIDE;
            d[at + PackedContacts.GAP0] = random.nextDouble(-1, 1);
            d[at + PackedContacts.GAP1] = random.nextDouble(-1, 1);
            double[] moved = dense.displacements();
            double[] gaps = new double[2];
            for (int point = 0; point < 2; point++) {
                gaps[point] = d[at + PackedContacts.GAP0 + point] + dense.along(row, point, moved);
                assertThat(motions.gap(contacts, row, point))
                        .isCloseTo(gaps[point], within(ROUND_OFF));
                assertThat(motions.parting(contacts, row, point))
                        .isCloseTo(dense.speed(row, point), within(ROUND_OFF));
            }
            assertThat(motions.gap(contacts, row))
                    .isCloseTo(Math.min(gaps[0], gaps[1]), within(ROUND_OFF));
            contacts.points[row] = 1;
            assertThat(motions.gap(contacts, row)).isCloseTo(gaps[0], within(ROUND_OFF));
            double armA = d[at + PackedContacts.LEVER_TA];
            double armB = d[at + PackedContacts.LEVER_TB];
            assertThat(motions.slide(contacts, row, armA, armB))
                    .isCloseTo(dense.speed(row, DenseRows.TANGENT), within(ROUND_OFF));
            assertThat(motions.slid(contacts, row, armA, armB))
                    .isCloseTo(dense.along(row, DenseRows.TANGENT, moved), within(ROUND_OFF));
            double response = dense.response(row, 0, row, 1);
            assertThat(
                            motions.response(
                                    contacts.bodyA[row],
                                    contacts.bodyB[row],
                                    d[at + PackedContacts.LEVER_A0],
                                    d[at + PackedContacts.LEVER_B0],
                                    d[at + PackedContacts.LEVER_A1],
                                    d[at + PackedContacts.LEVER_B1]))
                    .isCloseTo(response, within(ROUND_OFF));
        }
    }

    /** Rows numbered one by one are the rows of contacts. */
    @Test
    void singleRowsAreTheRowsOfContacts() {
        SplittableRandom random = new SplittableRandom(2);
        SingleRows single = new SingleRows(contacts);
        for (int i = 0; i < 100; i++) {
            island.bodies(random, 3);
            island.contact(random, 0, 1);
            int row = island.contact(random, 2, 3);
            island.run(row, 0.7);
            for (int kind = 0; kind < SingleRows.ROWS_PER_CONTACT; kind++) {
                int id = SingleRows.ROWS_PER_CONTACT * row + kind;
                double speed = single.relative(motions.data, id);
                assertThat(speed).isCloseTo(dense.speed(row, kind), within(ROUND_OFF));
                assertThat(single.running(id)).isEqualTo(kind == SingleRows.TANGENT ? 0.7 : 0);
                double[] before = dense.velocities();
                single.push(motions.data, id, 0.3);
                double[] unit = new double[DenseRows.KINDS * contacts.count];
                unit[DenseRows.KINDS * row + kind] = 0.3;
                double[] change = dense.change(unit);
                for (int k = 3; k < change.length; k++) {
                    assertThat(dense.velocities()[k] - before[k])
                            .isCloseTo(change[k], within(ROUND_OFF));
                }
            }
        }
        assertThat(SingleRows.impulseColumn(3)).isEqualTo(PackedContacts.IMPULSE0);
        assertThat(SingleRows.impulseColumn(4)).isEqualTo(PackedContacts.IMPULSE1);
        assertThat(SingleRows.impulseColumn(5)).isEqualTo(PackedContacts.IMPULSE_T);
    }

    @Test
    void driftMovesBodiesAlongTheirVelocities() {
        SplittableRandom random = new SplittableRandom(3);
        island.bodies(random, 4);
        place(random);
        double[] places = dense.displacements();
        double[] speeds = dense.velocities();
        motions.drift(0.25);
        for (int i = 3; i < places.length; i++) {
            assertThat(dense.displacements()[i])
                    .isCloseTo(places[i] + 0.25 * speeds[i], within(ROUND_OFF));
        }
        assertThat(dense.velocities()).isEqualTo(speeds);
        places = dense.displacements();
        motions.halt(2 * Motions.STRIDE);
        assertThat(Arrays.copyOfRange(dense.velocities(), 6, 9)).containsOnly(0);
        assertThat(dense.velocities()[3]).isEqualTo(speeds[3]);
        motions.halt();
        assertThat(dense.velocities()).containsOnly(0);
        assertThat(dense.displacements()).isEqualTo(places);
    }

    /** Σ m·v²/2 + I·ω²/2 of all movable bodies; masses and their ratio likewise. */
    @Test
    void energyAndMassesAreThoseOfMovableBodies() {
        island.begin(3);
        island.body(1, 0.5, 0.25);
        island.body(2, 4, 0);
        island.body(3, 0, 0);
        double[] m = motions.data;
        for (int entry = 1; entry <= 3; entry++) {
            m[entry * Motions.STRIDE + Motions.VX] = 3;
            m[entry * Motions.STRIDE + Motions.VY] = -4;
            m[entry * Motions.STRIDE + Motions.SPIN] = 2;
        }
        // 2 kg and 4 kg·m²; 1/4 kg that does not turn; and a driven body.
        assertThat(motions.energy(m)).isCloseTo(25 + 8 + 25.0 / 8, within(ROUND_OFF));
        assertThat(motions.mass()).isCloseTo(2.25, within(ROUND_OFF));
        assertThat(motions.massRatio()).isCloseTo(8, within(ROUND_OFF));
        assertThat(motions.fastest()).isEqualTo(4);
        m[2 * Motions.STRIDE + Motions.VX] = -5;
        assertThat(motions.fastest()).isEqualTo(5);
        motions.moveAll(0.1, -0.2);
        assertThat(dense.displacements())
                .containsExactly(0, 0, 0, 0.1, -0.2, 0, 0.1, -0.2, 0, 0, 0, 0);
        island.begin(1);
        assertThat(motions.massRatio()).isEqualTo(1);
    }

    /** Upper bound on the way of the outline: along both axes and by the turn at its radius. */
    @Test
    void movedBoundsTheWayOfTheOutline() {
        island.begin(1);
        island.body(1, 1, 1);
        motions.reach[1] = 3;
        assertThat(motions.areWhereTheyWere()).isTrue();
        for (int column : new int[] {Motions.DX, Motions.DY, Motions.TURN}) {
            motions.data[Motions.STRIDE + column] = -0.1;
            assertThat(motions.areWhereTheyWere()).isFalse();
            double way = column == Motions.TURN ? 0.3 : 0.1;
            assertThat(motions.moved(Motions.STRIDE)).isCloseTo(way, within(ROUND_OFF));
            motions.data[Motions.STRIDE + column] = 0;
        }
    }

    /** A body is packed once; bodies at rest count as the ground. */
    @Test
    void bodiesArePackedOnce() {
        bodies.type[3] = BodyType.DYNAMIC;
        bodies.awake[3] = true;
        bodies.velocityX[3] = 2;
        bodies.velocityY[3] = 3;
        bodies.inverseMass[3] = 4;
        bodies.boundingRadius[3] = 5;
        bodies.type[5] = BodyType.STATIC;
        bodies.type[6] = BodyType.KINEMATIC;
        motions.clear(bodies);
        assertThat(motions.offset(bodies, 5)).isZero();
        int at = motions.offset(bodies, 3);
        assertThat(at).isEqualTo(Motions.STRIDE);
        assertThat(motions.offset(bodies, 3)).isEqualTo(at);
        assertThat(motions.count).isEqualTo(2);
        assertThat(motions.slots[1]).isEqualTo(3);
        assertThat(motions.reach[1]).isEqualTo(5);
        assertThat(Arrays.copyOfRange(motions.data, at, at + Motions.STRIDE))
                .containsExactly(2, 3, 0, 0, 0, 0, 4, 0);
        assertThat(motions.isAnyDriven).isFalse();
        bodies.velocityX[6] = 1;
        assertThat(motions.offset(bodies, 6)).isEqualTo(2 * Motions.STRIDE);
        assertThat(motions.isAnyDriven).isTrue();
        motions.clear(bodies);
        assertThat(motions.count).isEqualTo(1);
        assertThat(motions.isAnyDriven).isFalse();
    }

    /** From the present place along the velocity, in the frame since the step's start. */
    @Test
    void placesArePredicted() {
        island.begin(1);
        island.body(1, 1, 1);
        bodies.x[0] = 10;
        bodies.y[0] = 20;
        int at = Motions.STRIDE;
        motions.data[at + Motions.DX] = 1;
        motions.data[at + Motions.DY] = 2;
        motions.data[at + Motions.VX] = 4;
        motions.data[at + Motions.VY] = -4;
        assertThat(motions.isInWorld()).isTrue();
        motions.takeFrame(100, 0);
        assertThat(motions.isInWorld()).isFalse();
        motions.takeFrame(100, 1000);
        assertThat(motions.x(bodies, at, 0.5, 0.25)).isCloseTo(10 + 1 + 2 + 25, within(1e-12));
        assertThat(motions.y(bodies, at, 0.5, 0.25)).isCloseTo(20 + 2 - 2 + 250, within(1e-12));
        motions.takeFrame(0, 0);
    }

    @Test
    void fewAreFollowedClosely() {
        island.begin(Motions.FEW);
        assertThat(motions.areFew()).isTrue();
        island.begin(Motions.FEW + 1);
        assertThat(motions.areFew()).isFalse();
        motions.areFollowed = true;
        assertThat(motions.areFew()).isTrue();
    }

    /** Displacements since a moment are read and scaled, body by body or all at once. */
    @Test
    void displacementsAreScaled() {
        SplittableRandom random = new SplittableRandom(4);
        island.bodies(random, 20);
        place(random);
        double[] before = dense.displacements();
        double[] speeds = dense.velocities();
        Displacement moved = new Displacement(motions);
        moved.begin();
        place(random);
        double[] now = dense.displacements();
        int second = 2 * Motions.STRIDE;
        assertThat(moved.of(second + Motions.DY)).isEqualTo(now[7] - before[7]);
        moved.scale(second, 0.5);
        for (int i = 3; i < now.length; i++) {
            double truth = i / 3 == 2 ? (before[i] + now[i]) / 2 : now[i];
            assertThat(dense.displacements()[i]).isCloseTo(truth, within(ROUND_OFF));
        }
        moved.scaleAll(0);
        assertThat(dense.displacements()).isEqualTo(before);
        assertThat(dense.velocities()).isEqualTo(speeds);
    }
}
