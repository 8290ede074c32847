package rigibo.lab.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class ScaleTest {

    @Test
    void equalRatiosAreEquallyFarApart() {
        LogScale scale = new LogScale(1e-6, 1e-2, 0, 400);
        assertThat(scale.at(1e-6)).isZero();
        assertThat(scale.at(1e-5)).isCloseTo(100, within(1e-9));
        assertThat(scale.at(1e-2)).isEqualTo(400);
        assertThat(scale.at(1)).isEqualTo(400);
        assertThat(scale.at(0)).isZero();
    }

    @Test
    void ticksArePowersOfTenWhereThereIsRoom() {
        assertThat(new LogScale(2e-4, 0.5, 0, 400).ticks()).containsExactly(1e-3, 1e-2, 1e-1);
        assertThat(new LogScale(1e-9, 1, 300, 0).ticks())
                .containsExactly(1e-9, 1e-7, 1e-5, 1e-3, 1e-1);
    }

    @Test
    void fewDecadesHaveTicksBetween() {
        assertThat(new LogScale(1, 10, 0, 400).ticks()).containsExactly(1.0, 2.0, 5.0, 10.0);
    }

    @Test
    void differencesAreEquallyFarApartUpwardsToo() {
        LinearScale scale = new LinearScale(-1, 3, 200, 0);
        assertThat(scale.at(0)).isEqualTo(150);
        assertThat(scale.ticks()).contains(-1.0, 0.0, 3.0);
    }
}
