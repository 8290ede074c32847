package rigibo.backend.contact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.setup.Accuracy;
import rigibo.lab.hardcase.Preset;

/** Columns of bodies, and multiples of what passes over their contacts take. */
class EliminationBudgetTest {

    /** Multiplications of passes per contact and substep. */
    private static final double OF_PASSES = 360;

    /** Speed that a body gains by gravity in a step, m/s. */
    private static final double GAINED = 9.81 / 60;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;

    /** Stacks a number of bodies, of which the uppermost has a multiple of the others' mass. */
    private EliminationBudget column(int count, double ratio, Accuracy accuracy) {
        island.begin(count);
        for (int entry = 1; entry <= count; entry++) {
            island.body(entry, entry == count ? 1 / ratio : 1, 0);
            island.contact(entry - 1, entry, 0, 0);
        }
        return new EliminationBudget(motions, island.contacts, accuracy);
    }

    /** Lets the bodies of a column part from each other, or close, by a speed in m/s. */
    private void part(double speed) {
        for (int entry = 1; entry < motions.count; entry++) {
            motions.data[entry * Motions.STRIDE + Motions.VY] = entry * speed;
        }
    }

    private void load() {
        for (int row = 0; row < island.contacts.count; row++) {
            island.set(row, PackedContacts.IMPULSE0, 1);
        }
    }

    /** A quarter of the work of passes, times the ratio of masses, up to 300 times. */
    @ParameterizedTest
    @CsvSource({"1, 0.25", "2, 0.5", "40, 10", "1199, 299.75", "1201, 300", "1e6, 300"})
    void movingIslandIsWorthMoreTheMoreItsMassesDiffer(double ratio, double times) {
        EliminationBudget budget = column(100, ratio, Accuracy.GAME);
        part(-1);
        assertThat(budget.ofSubstep(false, GAINED))
                .isCloseTo(times * 100 * OF_PASSES, within(1e-6));
        assertThat(EliminationBudget.timesByMass(motions)).isCloseTo(times, within(1e-12));
    }

    /** Passes reduce the error of elastic bodies by 1 − e² as much. */
    @ParameterizedTest
    @CsvSource({"0, 0.25", "0.5, 0.333333333333333", "0.9, 1.31578947368421", "1, 25"})
    void elasticIslandIsWorthMore(double elasticity, double times) {
        EliminationBudget budget = column(100, 1, Accuracy.GAME);
        part(-1);
        island.set(7, PackedContacts.ELASTICITY, elasticity);
        assertThat(budget.ofSubstep(false, GAINED))
                .isCloseTo(times * 100 * OF_PASSES, within(1e-6));
    }

    @Test
    void whatPressesASingleOrADrivenBodyIsWorthEightTimesThePasses() {
        EliminationBudget alone = column(1, 1, Accuracy.GAME);
        part(-1);
        assertThat(alone.ofSubstep(false, GAINED)).isEqualTo(8 * OF_PASSES);
        EliminationBudget many = column(100, 1, Accuracy.GAME);
        part(-1);
        motions.isAnyDriven = true;
        assertThat(many.ofSubstep(false, GAINED)).isEqualTo(8 * 100 * OF_PASSES);
    }

    /** At DRAFT, of four times the length, a small island is worth twice as much. */
    @ParameterizedTest
    @CsvSource({"DRAFT, 5000", "GAME, 2500", "FINE, 2500"})
    void smallIslandIsWorthSomeMicroseconds(Preset preset, double least) {
        EliminationBudget budget = column(2, 1, preset.accuracy());
        part(-1);
        assertThat(budget.ofSubstep(false, GAINED)).isEqualTo(least);
    }

    /** Twelve times the passes at GAME, and in proportion to the substeps below. */
    @ParameterizedTest
    @CsvSource({"DRAFT, 3", "GAME, 12", "FINE, 12"})
    void calmIslandIsWorthMore(Preset preset, double times) {
        EliminationBudget budget = column(100, 1, preset.accuracy());
        part(-1);
        assertThat(budget.ofSubstep(true, GAINED)).isCloseTo(times * 100 * OF_PASSES, within(1e-6));
    }

    /** Bodies that move together count as calm, however fast; a thousandth of a fall is allowed. */
    @Test
    void islandWhoseContactsPersistCountsAsCalm() {
        EliminationBudget budget = column(100, 1, Accuracy.GAME);
        double calm = 12 * 100 * OF_PASSES;
        double moving = 0.25 * 100 * OF_PASSES;
        for (double speed : new double[] {0, 0.9e-3, -0.9e-3}) {
            part(speed * GAINED);
            load();
            assertThat(budget.ofSubstep(false, GAINED)).isEqualTo(calm);
        }
        for (double speed : new double[] {1.1e-3, -1.1e-3}) {
            part(speed * GAINED);
            assertThat(budget.ofSubstep(false, GAINED)).isEqualTo(moving);
        }
        EliminationBudget unloaded = column(100, 1, Accuracy.GAME);
        part(1);
        assertThat(unloaded.ofSubstep(false, GAINED)).isEqualTo(calm);
    }

    @Test
    void impactsAreWorthThePassesOfTheirKicks() {
        assertThat(column(100, 1, Accuracy.GAME).ofImpacts(5)).isEqualTo(5 * 100 * OF_PASSES);
        assertThat(column(10, 1, Accuracy.GAME).ofImpacts(5)).isEqualTo(1e5);
    }

    @Test
    void anyWorkIsAllowedFromExactOn() {
        EliminationBudget budget = column(2, 1, Accuracy.EXACT);
        part(-1);
        assertThat(budget.ofSubstep(false, GAINED)).isInfinite();
        assertThat(budget.ofSubstep(true, GAINED)).isInfinite();
        assertThat(budget.ofImpacts(1)).isInfinite();
    }
}
