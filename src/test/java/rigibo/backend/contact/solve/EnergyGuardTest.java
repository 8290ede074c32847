package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.contact.row.DenseRows;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;

import java.util.SplittableRandom;

/** Random impulses that add energy or make bodies too fast, and the guard's results. */
class EnergyGuardTest {

    private static final double ROUND_OFF = 1e-9;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final DenseRows dense = new DenseRows(island);
    private final EnergyGuard guard = new EnergyGuard(motions, contacts);

    /** Velocities before any impulse, and the impulses. */
    private double[] free;

    private double[] given;

    /** A chain of bodies whose contacts get random impulses after the guard has begun. */
    private void strike(SplittableRandom random, int count, double strength) {
        island.bodies(random, count);
        for (int entry = 1; entry <= count; entry++) {
            island.contact(random, entry - 1, entry);
        }
        guard.begin();
        free = dense.velocities();
        for (int row = 0; row < count; row++) {
            int at = row * PackedContacts.STRIDE;
            contacts.data[at + PackedContacts.IMPULSE0] = strength * random.nextDouble();
            contacts.data[at + PackedContacts.IMPULSE1] = strength * random.nextDouble();
            contacts.data[at + PackedContacts.IMPULSE_T] = strength * random.nextDouble(-1, 1);
            contacts.data[at + PackedContacts.IMPULSE_R] = strength * random.nextDouble(-1, 1);
        }
        given = dense.impulses();
        dense.applyImpulses();
    }

    /** The share of the first impulse that is left. */
    private double share() {
        return dense.impulses()[0] / given[0];
    }

    private void assertAllKeep(double share) {
        double[] change = dense.change(given);
        double[] now = dense.velocities();
        double[] impulses = dense.impulses();
        for (int k = 0; k < given.length; k++) {
            assertThat(impulses[k]).isCloseTo(share * given[k], within(ROUND_OFF));
        }
        for (int i = 3; i < now.length; i++) {
            assertThat(now[i]).isCloseTo(free[i] + share * change[i], within(ROUND_OFF));
        }
    }

    /** Work beyond the allowed one is removed by scaling all impulses down, exactly to it. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1, 1})
    void impulsesDoNoMoreWorkThanTheyMay(double most) {
        SplittableRandom random = new SplittableRandom(1);
        int scaled = 0;
        int stopped = 0;
        for (int i = 0; i < 300; i++) {
            strike(random, 3, random.nextDouble(2));
            double before = energyAt(free);
            boolean adds = dense.energy() > before + most;
            guard.limitWork(most);
            double share = share();
            assertAllKeep(share);
            if (!adds) {
                assertThat(share).isEqualTo(1);
            } else if (share > 0) {
                scaled++;
                assertThat(dense.energy()).isCloseTo(before + most, within(ROUND_OFF));
            } else {
                // Any share of them would add energy, so all of them are removed.
                stopped++;
                assertThat(most).isZero();
            }
        }
        assertThat(scaled).isGreaterThan(50);
        assertThat(stopped).isGreaterThan(most == 0 ? 20 : -1);
    }

    private double energyAt(double[] velocities) {
        double sum = 0;
        for (int i = 3; i < velocities.length; i++) {
            int mass = i % 3 == 2 ? Motions.INVERSE_INERTIA : Motions.INVERSE_MASS;
            double inverse = motions.data[i / 3 * Motions.STRIDE + mass];
            sum += velocities[i] * velocities[i] / (2 * inverse);
        }
        return sum;
    }

    @Test
    void growthIsAMultipleOfTheEnergyBefore() {
        SplittableRandom random = new SplittableRandom(2);
        strike(random, 3, 20);
        guard.limitGrowth(0.5);
        assertThat(dense.energy()).isCloseTo(1.5 * energyAt(free), within(ROUND_OFF));
        strike(random, 3, 20);
        guard.limitEnergy();
        assertThat(dense.energy()).isLessThan(energyAt(free) + ROUND_OFF);
    }

    /** A running surface does work: impulses along it may add that. */
    @Test
    void whatRunsMayDoWork() {
        SplittableRandom random = new SplittableRandom(3);
        island.bodies(random, 1);
        int row = island.contact(random, 0, 1);
        int at = row * PackedContacts.STRIDE;
        for (int column = Motions.VX; column <= Motions.SPIN; column++) {
            motions.data[Motions.STRIDE + column] = 0;
        }
        guard.begin();
        island.run(row, 2);
        double impulse = 2 * contacts.data[at + PackedContacts.MASS_T];
        contacts.data[at + PackedContacts.IMPULSE_T] = impulse;
        dense.applyImpulses();
        double energy = dense.energy();
        guard.limitEnergy();
        assertThat(contacts.data[at + PackedContacts.IMPULSE_T]).isEqualTo(impulse);
        assertThat(dense.energy()).isEqualTo(energy).isGreaterThan(0.1);
    }

    /** A body that impulses made too fast keeps only the share up to the limit. */
    @Test
    void nothingIsFasterThanTheLimit() {
        SplittableRandom random = new SplittableRandom(4);
        int scaled = 0;
        for (int i = 0; i < 300; i++) {
            strike(random, 4, random.nextDouble(3));
            double limit = 1.5;
            double fastest = motions.fastest();
            guard.limitSpeed(limit);
            double share = share();
            assertAllKeep(share);
            if (fastest <= limit) {
                assertThat(share).isEqualTo(1);
            } else {
                scaled++;
                assertThat(motions.fastest()).isLessThan(limit + ROUND_OFF);
                assertThat(share).isBetween(0.0, 1.0);
            }
        }
        assertThat(scaled).isGreaterThan(100);
    }

    /** One body at rest keeps exactly the share that gives it the greatest speed. */
    @Test
    void aBodyAtRestKeepsAsMuchAsItMay() {
        SplittableRandom random = new SplittableRandom(5);
        strike(random, 1, 10);
        for (int column = Motions.VX; column <= Motions.SPIN; column++) {
            motions.data[Motions.STRIDE + column] -= free[3 + column];
        }
        guard.limitSpeed(0.1);
        assertThat(motions.fastest()).isCloseTo(0.1, within(ROUND_OFF));
    }

    /** In a crowd only impulses on fast bodies are scaled down; distant ones stay. */
    @Test
    void crowdKeepsItsLoadsUnderAFastStone() {
        SplittableRandom random = new SplittableRandom(6);
        strike(random, 70, 1e-3);
        int last = 69 * PackedContacts.STRIDE;
        contacts.data[last + PackedContacts.IMPULSE0] += 100;
        double[] more = new double[given.length];
        more[69 * DenseRows.KINDS] = 100;
        double[] change = dense.change(more);
        for (int i = 3; i < change.length; i++) {
            motions.data[i / 3 * Motions.STRIDE + i % 3] += change[i];
        }
        given = dense.impulses();
        dense.begin();
        guard.limitSpeed(1.5);
        assertThat(motions.fastest()).isLessThan(1.5 + ROUND_OFF);
        assertThat(dense.impulses()[0]).isEqualTo(given[0]);
        assertThat(dense.impulses()[69 * DenseRows.KINDS]).isLessThan(50);
        // Momentum: both bodies of a contact lose the same share.
        dense.assertImpulsesTellAll(ROUND_OFF);
    }
}
