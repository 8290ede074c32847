package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.DenseRows;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Rotation;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

import java.util.SplittableRandom;

/** Friction rows of random contacts, compared with their written-out rows. */
class FrictionSolverTest {

    private static final double ROUND_OFF = 1e-12;

    /** The compliance of a row leaves 10⁻¹⁰ of its impulse. */
    private static final double GIVEN_WAY = 1e-9;

    private final PackedIsland island = new PackedIsland();
    private final PackedContacts contacts = island.contacts;
    private final DenseRows dense = new DenseRows(island);
    private final DataStorage data =
            new DataStorage(Effects.of(new Contacts(), new Rotation(), new Friction()));
    private final Pairs pairs = data.pairs;
    private final FrictionSolver friction = new FrictionSolver(island.motions, contacts, pairs);

    private int contact(SplittableRandom random, int a, int b, double coefficient) {
        int row = island.contact(random, a, b);
        contacts.pair[row] = row;
        pairs.friction[row] = coefficient;
        pairs.normalForce[2 * row] = 1;
        return row;
    }

    @Test
    void whatHoldsDoesNotSlideAndWhatSlidesIsBrakedByItsLoad() {
        SplittableRandom random = new SplittableRandom(1);
        int held = 0;
        for (int i = 0; i < 500; i++) {
            island.bodies(random, 2);
            int row = contact(random, 1, 2, random.nextDouble(0.1, 1));
            friction.begin(0);
            contacts.surface[row] = random.nextDouble(-1, 1);
            island.set(row, PackedContacts.IMPULSE0, random.nextDouble());
            island.set(row, PackedContacts.IMPULSE1, random.nextDouble());
            double cone = pairs.friction[row] * (dense.impulses()[0] + dense.impulses()[1]);
            dense.begin();
            friction.slide(row);
            double slides = dense.speed(row, DenseRows.TANGENT) - contacts.surface[row];
            double impulse = island.of(row, PackedContacts.IMPULSE_T);
            assertThat(friction.slidingSpeed(row)).isCloseTo(slides, within(ROUND_OFF));
            assertThat(Math.abs(impulse)).isLessThanOrEqualTo(cone);
            dense.assertImpulsesTellAll(ROUND_OFF);
            if (Math.abs(impulse) < cone) {
                held++;
                assertThat(slides).isCloseTo(0, within(GIVEN_WAY));
            } else {
                assertThat(slides * impulse).isLessThan(0);
            }
        }
        assertThat(held).isBetween(200, 480);
    }

    /** Impulses start with the force of the last step times the length of the kick. */
    @Test
    void onlyContactsWithFrictionHaveRows() {
        SplittableRandom random = new SplittableRandom(2);
        island.bodies(random, 3);
        contact(random, 0, 1, 0);
        int rubs = contact(random, 1, 2, 0.5);
        contact(random, 2, 3, 0);
        pairs.frictionForce[0] = 9;
        pairs.frictionForce[rubs] = 4;
        friction.begin(0.1);
        assertThat(friction.rowCount()).isEqualTo(1);
        assertThat(island.of(rubs, PackedContacts.FRICTION)).isEqualTo(0.5);
        assertThat(island.of(rubs, PackedContacts.IMPULSE_T)).isCloseTo(0.4, within(ROUND_OFF));
        assertThat(island.of(0, PackedContacts.IMPULSE_T)).isZero();
        assertThat(island.of(0, PackedContacts.FRICTION)).isZero();
        double response = dense.response(rubs, DenseRows.TANGENT, rubs, DenseRows.TANGENT);
        assertThat(island.of(rubs, PackedContacts.MASS_T))
                .isCloseTo(1 / response, within(ROUND_OFF));
        friction.begin(0.2);
        assertThat(friction.rowCount()).isEqualTo(1);
    }

    @Test
    void newLeversHaveNewMasses() {
        SplittableRandom random = new SplittableRandom(3);
        island.bodies(random, 1);
        int row = contact(random, 0, 1, 0.5);
        friction.begin(0.1);
        island.set(row, PackedContacts.LEVER_TB, 2);
        friction.refresh();
        double response = dense.response(row, DenseRows.TANGENT, row, DenseRows.TANGENT);
        assertThat(island.of(row, PackedContacts.MASS_T))
                .isCloseTo(1 / response, within(ROUND_OFF));
    }

    /** The impulse is that of half a kick, h/2: the force is twice it over h. */
    @Test
    void forcesAreStored() {
        SplittableRandom random = new SplittableRandom(4);
        island.bodies(random, 2);
        contact(random, 0, 1, 0);
        int row = contact(random, 1, 2, 0.5);
        friction.begin(0);
        island.set(row, PackedContacts.IMPULSE_T, 3);
        pairs.frictionForce[0] = 7;
        friction.store(0.1);
        assertThat(pairs.frictionForce[row]).isCloseTo(60, within(ROUND_OFF));
        assertThat(pairs.frictionForce[0]).isEqualTo(7);
    }

    /** There are more contacts than in any island before. */
    @Test
    void anyNumberOfContactsMayRub() {
        SplittableRandom random = new SplittableRandom(5);
        island.bodies(random, 40);
        for (int entry = 1; entry <= 40; entry++) {
            int row = island.contact(random, entry - 1, entry);
            contacts.pair[row] = 0;
        }
        pairs.friction[0] = 1;
        friction.begin(0);
        assertThat(friction.rowCount()).isEqualTo(40);
        assertThat(island.of(39, PackedContacts.FRICTION)).isEqualTo(1);
    }
}
