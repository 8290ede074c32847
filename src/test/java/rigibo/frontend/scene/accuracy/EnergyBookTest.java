package rigibo.frontend.scene.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class EnergyBookTest {

    private final EnergyBook book = new EnergyBook();

    private void steps(double... joules) {
        for (int i = 1; i < joules.length; i++) {
            book.before(joules[i - 1]);
            book.after(joules[i]);
        }
    }

    @Test
    void everyChangeIsDriftWhereNothingTakesEnergy() {
        steps(10, 8, 9);
        assertThat(book.drift(EnergyKind.CONSERVED)).isEqualTo(-1);
        assertThat(book.lost(EnergyKind.CONSERVED)).isZero();
    }

    @Test
    void aFallIsLostByDesignAndARiseIsDrift() {
        steps(10, 8, 9, 8.5);
        assertThat(book.lost(EnergyKind.LOSING)).isEqualTo(2);
        assertThat(book.drift(EnergyKind.LOSING)).isEqualTo(0.5);
    }

    @Test
    void whereWorkIsDoneNothingIsCalledDrift() {
        steps(10, 14);
        assertThat(book.work(EnergyKind.WORKED)).isEqualTo(4);
        assertThat(book.drift(EnergyKind.WORKED)).isZero();
    }

    @ParameterizedTest
    @EnumSource(EnergyKind.class)
    void thePartsAddUpToTheChange(EnergyKind kind) {
        steps(10, 7, 12, 6, 8);
        double told = book.first() - book.lost(kind) + book.drift(kind) + book.work(kind);
        assertThat(told).isCloseTo(8, within(1e-15));
    }

    @Test
    void anEditBeginsANewAccount() {
        steps(10, 7);
        book.before(20);
        book.after(19);
        assertThat(book.steps()).isEqualTo(1);
        assertThat(book.first()).isEqualTo(20);
        assertThat(book.lost(EnergyKind.LOSING)).isEqualTo(1);
    }

    @Test
    void theCurveHoldsTheLastTenSeconds() {
        double[] joules = new double[EnergyBook.WINDOW + 3];
        for (int i = 0; i < joules.length; i++) {
            joules[i] = i;
        }
        steps(joules);
        double[] curve = new double[EnergyBook.WINDOW];
        assertThat(book.curve(EnergyKind.CONSERVED, curve)).isEqualTo(EnergyBook.WINDOW);
        assertThat(curve).startsWith(3).endsWith(joules.length - 1).isSorted();
    }
}
