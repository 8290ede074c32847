package rigibo.backend.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.Allocation;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.geometry.Circle;

/** s·rⁿ towards the centre, whatever the mass. */
class CentralPullTest {

    private static Instant pulled(double x, double y, double strength, double power) {
        Instant at = Instants.of(new Circle(1), 7, 1, 0);
        at.x = x;
        at.y = y;
        at.accelerationX = 1;
        at.accelerationY = 2;
        new CentralPull(new CentralForce(10, 20, strength, power)).add(at);
        return at;
    }

    /** 3 m east and 4 m north of the centre, 5 m away: pulled by 3·5ⁿ to −3/5 and −4/5. */
    @ParameterizedTest
    @ValueSource(doubles = {-8, -3, -2, -1, 0, 0.5, 1, 2, 8})
    void isThePowerOfTheDistance(double power) {
        double pull = 3 * Math.pow(5, power);
        Instant at = pulled(13, 24, 3, power);

        // Some units in the last place of the sum, and of the 1 and 2 that it is added to.
        double roundOff = 1e-14 * (pull + 2);
        assertThat(at.accelerationX).isEqualTo(1 - pull * 3 / 5, within(roundOff));
        assertThat(at.accelerationY).isEqualTo(2 - pull * 4 / 5, within(roundOff));
        assertThat(at.angularAcceleration).isZero();
    }

    /** A negative strength pushes away; from the left of and under the centre. */
    @ParameterizedTest
    @CsvSource({"-2", "1"})
    void pushesAwayWhereItIsNegative(double power) {
        double push = 3 * Math.pow(5, power);
        Instant at = pulled(6, 17, -3, power);

        assertThat(at.accelerationX).isEqualTo(1 - push * 4 / 5, within(1e-13));
        assertThat(at.accelerationY).isEqualTo(2 - push * 3 / 5, within(1e-13));
    }

    /** At 5 mm gravity is a million times as strong as at 5 m. */
    @Test
    void isSteepNearTheCentre() {
        Instant at = pulled(10.003, 20.004, 3, -2);
        double pull = 3 / (0.005 * 0.005);

        // 20.004 is known to 2e-15, which is 1e-12 of the 0.004 that is left of it.
        assertThat(at.accelerationX).isEqualTo(1 - pull * 3 / 5, within(1e-11 * pull));
        assertThat(at.accelerationY).isEqualTo(2 - pull * 4 / 5, within(1e-11 * pull));
    }

    /** There is no direction to pull in, however steep the power. */
    @ParameterizedTest
    @ValueSource(doubles = {-8, -2, -1, 0, 1})
    void isNothingAtTheCentre(double power) {
        Instant at = pulled(10, 20, 3, power);

        assertThat(at.accelerationX).isEqualTo(1);
        assertThat(at.accelerationY).isEqualTo(2);
    }

    @Test
    void allocatesNothingWhateverThePower() {
        CentralPull pull = new CentralPull(new CentralForce(10, 20, 3, 0.3));
        Instant at = Instants.of(new Circle(1), 7, 1, 0);
        Runnable pulls =
                () -> {
                    for (int i = 0; i < 1000; i++) {
                        pull.add(at);
                    }
                };

        assertThat(Allocation.ofThirdRun(pulls)).isZero();
    }
}
