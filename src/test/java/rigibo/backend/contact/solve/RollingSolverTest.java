package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.DenseRows;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

import java.util.SplittableRandom;

/** Rolling rows of random contacts, with and without friction. */
class RollingSolverTest {

    private static final double ROUND_OFF = 1e-11;
    private static final double GIVEN_WAY = 1e-9;

    private final PackedIsland island = new PackedIsland();
    private final PackedContacts contacts = island.contacts;
    private final DenseRows dense = new DenseRows(island);
    private final DataStorage data =
            new DataStorage(
                    Effects.of(
                            new Contacts(),
                            new Rotation(),
                            new Friction(),
                            new RollingResistance()));
    private final Pairs pairs = data.pairs;
    private final FrictionSolver friction = new FrictionSolver(island.motions, contacts, pairs);
    private final RollingSolver rolling =
            new RollingSolver(data, island.motions, contacts, friction);
    private final RollingSolver smooth = new RollingSolver(data, island.motions, contacts, null);

    /** A contact of two bodies, in slots of their own. */
    private int contact(SplittableRandom random, double coefficient, double lever) {
        island.bodies(random, 2);
        int row = island.contact(random, 1, 2);
        contacts.pair[row] = row;
        pairs.bodyA[row] = 1;
        pairs.bodyB[row] = 2;
        pairs.friction[row] = coefficient;
        pairs.normalForce[2 * row] = 1;
        data.bodies.rollingResistance[1] = lever / 3;
        data.bodies.rollingResistance[2] = lever;
        return row;
    }

    private void load(SplittableRandom random, int row) {
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE0] = random.nextDouble();
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE1] = random.nextDouble();
    }

    /** If both rows hold, neither sliding nor turning is left after one solution. */
    @Test
    void rollingAndFrictionHoldTogether() {
        SplittableRandom random = new SplittableRandom(1);
        int both = 0;
        int turning = 0;
        int sliding = 0;
        for (int i = 0; i < 2_000; i++) {
            int row = contact(random, random.nextDouble(0.1, 3), random.nextDouble(0.1, 3));
            rolling.begin(0);
            contacts.surface[row] = random.nextDouble(-0.5, 0.5);
            load(random, row);
            double load = dense.impulses()[0] + dense.impulses()[1];
            dense.begin();
            rolling.roll(row);
            dense.assertImpulsesTellAll(ROUND_OFF);
            double slides = dense.speed(row, DenseRows.TANGENT) - contacts.surface[row];
            double turns = dense.speed(row, DenseRows.ROLLING);
            double tangent = island.of(row, PackedContacts.IMPULSE_T);
            double roll = island.of(row, PackedContacts.IMPULSE_R);
            double cone = pairs.friction[row] * load;
            double bound = island.of(row, PackedContacts.ROLLING) * load;
            assertThat(Math.abs(tangent)).isLessThanOrEqualTo(cone);
            assertThat(Math.abs(roll)).isLessThanOrEqualTo(bound);
            if (Math.abs(slides) < GIVEN_WAY && Math.abs(turns) < GIVEN_WAY) {
                both++;
            } else if (Math.abs(roll) == bound) {
                turning++;
                // Rolling was solved before friction.
                assertThat(Math.abs(tangent) == cone || Math.abs(slides) < GIVEN_WAY).isTrue();
            } else {
                sliding++;
            }
        }
        assertThat(both).isBetween(300, 1_950);
        assertThat(turning).isGreaterThan(50);
        assertThat(sliding).isGreaterThan(20);
    }

    /** Braked by c·N alone, like a wheel under a brake. */
    @Test
    void withoutFrictionOnlyTurningIsBraked() {
        SplittableRandom random = new SplittableRandom(2);
        int held = 0;
        for (int i = 0; i < 500; i++) {
            int row = contact(random, 0, random.nextDouble(0.1, 1));
            smooth.begin(0);
            load(random, row);
            double bound =
                    island.of(row, PackedContacts.ROLLING)
                            * (dense.impulses()[0] + dense.impulses()[1]);
            double turned = dense.speed(row, DenseRows.ROLLING);
            double response = dense.response(row, DenseRows.ROLLING, row, DenseRows.ROLLING);
            dense.begin();
            smooth.roll(row);
            dense.assertImpulsesTellAll(ROUND_OFF);
            double left = Math.max(0, Math.abs(turned) - bound * response) * Math.signum(turned);
            assertThat(dense.speed(row, DenseRows.ROLLING)).isCloseTo(left, within(GIVEN_WAY));
            assertThat(island.of(row, PackedContacts.IMPULSE_T)).isZero();
            held += left == 0 ? 1 : 0;
        }
        assertThat(held).isBetween(50, 450);
    }

    /** Rolling starts with the torques of the last step; the longer lever counts. */
    @Test
    void rowsAreWrittenAndStored() {
        SplittableRandom random = new SplittableRandom(3);
        int row = contact(random, 0.5, 0.3);
        pairs.rollingTorque[row] = 2;
        pairs.frictionForce[row] = 5;
        rolling.begin(0.1);
        assertThat(rolling.rowCount()).isEqualTo(2);
        assertThat(island.of(row, PackedContacts.ROLLING)).isEqualTo(0.3);
        assertThat(island.of(row, PackedContacts.IMPULSE_R)).isCloseTo(0.2, within(ROUND_OFF));
        assertThat(island.of(row, PackedContacts.IMPULSE_T)).isCloseTo(0.5, within(ROUND_OFF));
        double response = dense.response(row, DenseRows.ROLLING, row, DenseRows.ROLLING);
        assertThat(island.of(row, PackedContacts.INERTIA_R))
                .isCloseTo(1 / response, within(ROUND_OFF));
        rolling.store(0.1);
        assertThat(pairs.rollingTorque[row]).isCloseTo(4, within(ROUND_OFF));
        assertThat(pairs.frictionForce[row]).isCloseTo(10, within(ROUND_OFF));
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.LEVER_TB] = 2;
        rolling.refresh();
        double slides = dense.response(row, DenseRows.TANGENT, row, DenseRows.TANGENT);
        assertThat(island.of(row, PackedContacts.MASS_T)).isCloseTo(1 / slides, within(ROUND_OFF));
    }

    @Test
    void smoothAndUnturnableBodiesHaveFewerRows() {
        SplittableRandom random = new SplittableRandom(4);
        contact(random, 0.5, 0);
        rolling.begin(0.1);
        assertThat(rolling.rowCount()).isEqualTo(1);
        smooth.begin(0.1);
        assertThat(smooth.rowCount()).isZero();
        int row = contact(random, 0, 0.2);
        island.motions.data[Motions.STRIDE + Motions.INVERSE_INERTIA] = 0;
        island.motions.data[2 * Motions.STRIDE + Motions.INVERSE_INERTIA] = 0;
        smooth.begin(0.1);
        smooth.refresh();
        smooth.store(0.1);
        assertThat(smooth.rowCount()).isEqualTo(1);
        assertThat(island.of(row, PackedContacts.INERTIA_R)).isZero();
    }
}
