package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.setup.Integrator;

/** Each method that integrates a path, compared with closed forms and with its order. */
class IntegratorsTest {

    /**
     * Under a force that grows with time a method of order 4 is exact: x = x₀ + v₀t + jt³/6, v = v₀
     * + jt²/2.
     */
    @ParameterizedTest
    @EnumSource(
            value = Integrator.class,
            names = {"RK4", "BALLISTIC"})
    void aForceThatGrowsGivesACubic(Integrator method) {
        Thrown thrown =
                new Thrown(Thrown.by(method), 0, at -> at.accelerate(6 * at.time, -12 * at.time));
        thrown.step(0.5, 0, 0);
        thrown.step(0.5, 0, 0);

        assertThat(thrown.bodies.x[0]).isEqualTo(1 + 3 + 1, within(1e-13));
        assertThat(thrown.bodies.y[0]).isEqualTo(2 + 4 - 2, within(1e-13));
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(3 + 3, within(1e-13));
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(4 - 6, within(1e-13));
    }

    /**
     * Under a constant acceleration all methods are exact, except symplectic Euler, which is
     * a·h·t/2 ahead.
     */
    @ParameterizedTest
    @EnumSource(Integrator.class)
    void aSteadyPullIsAParabola(Integrator method) {
        Thrown thrown = new Thrown(Thrown.by(method), 0, at -> at.accelerate(0, 0));
        thrown.step(0.5, 0.5, -8);

        double ahead = method == Integrator.EULER ? 0.25 / 2 : 0;
        assertThat(thrown.bodies.x[0]).isEqualTo(2.5625 + 0.5 * ahead, within(1e-14));
        assertThat(thrown.bodies.y[0]).isEqualTo(3 - 8 * ahead, within(1e-14));
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(3.25, within(1e-14));
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(0, within(1e-14));
    }

    /**
     * Under drag and a constant acceleration the exponential solution is exact; nothing is
     * integrated.
     */
    @Test
    void ballisticIsExactUnderDrag() {
        Thrown thrown = new Thrown(Thrown.by(Integrator.BALLISTIC), 2, at -> at.accelerate(0, 0));
        thrown.step(0.5, 0.5, -8);

        double e1 = (1 - Math.exp(-1)) / 2;
        double e2 = (0.5 - e1) / 2;
        assertThat(thrown.bodies.x[0]).isEqualTo(1 + 3 * e1 + 0.5 * e2, within(1e-14));
        assertThat(thrown.bodies.y[0]).isEqualTo(2 + 4 * e1 - 8 * e2, within(1e-14));
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(-4 + 8 * Math.exp(-1), within(1e-14));
    }

    /**
     * Error for a spring with ω = 2 and drag k: a damped oscillation about a place that a constant
     * acceleration moves.
     */
    private static double error(Integrator method, double drag, int steps) {
        Thrown thrown =
                new Thrown(Thrown.by(method), drag, at -> at.accelerate(-4 * at.x, -4 * at.y));
        double time = 1.25;
        for (int i = 0; i < steps; i++) {
            thrown.step(time / steps, 2, -4);
        }
        double damped = Math.sqrt(4 - drag * drag / 4);
        double left = Math.exp(-drag / 2 * time);
        double cos = left * Math.cos(damped * time);
        double sin = left * Math.sin(damped * time) / damped;
        double x = 0.5 + 0.5 * cos + (3 + 0.5 * drag / 2) * sin;
        double y = -1 + 3 * cos + (4 + 3 * drag / 2) * sin;
        double vx = 3 * cos - (4 * 0.5 + 3 * drag / 2) * sin;
        double vy = 4 * cos - (4 * 3 + 4 * drag / 2) * sin;
        return Math.hypot(thrown.bodies.x[0] - x, thrown.bodies.y[0] - y)
                + Math.hypot(thrown.bodies.velocityX[0] - vx, thrown.bodies.velocityY[0] - vy);
    }

    /** p = log₂(error(h)/error(h/2)), up to the effect of the next term at h = 1/50 s. */
    @ParameterizedTest(name = "{0} with drag {1} is of order {2}")
    @CsvSource({
        "EULER, 0, 1", "EULER, 1, 1", "VERLET, 0, 2", "VERLET, 1, 2",
        "RK4, 0, 4", "RK4, 1, 4", "BALLISTIC, 0, 4", "BALLISTIC, 1, 4"
    })
    void errorShrinksWithThePowerOfTheOrder(Integrator method, double drag, int order) {
        double coarse = error(method, drag, 64);
        double fine = error(method, drag, 128);

        assertThat(Math.log(coarse / fine) / Math.log(2)).isEqualTo(order, within(0.1));
        assertThat(fine).as("of the size of h to the order").isLessThan(40 * Math.pow(0.01, order));
    }

    /**
     * With kh = 3 the simple methods still take one step. Euler gives v(1 − kh) and moves at that
     * velocity; Verlet moves at v − kvh/2 and takes the mean of −kv and −k(v − kvh).
     */
    @ParameterizedTest
    @CsvSource({"EULER, -2, -2", "VERLET, 2.5, -0.5"})
    void theSimpleMethodsTakeTheStepTheyAreTold(Integrator method, double speed, double way) {
        Thrown thrown =
                new Thrown(
                        Thrown.by(method),
                        0,
                        at -> at.accelerate(-6 * at.velocityX, -6 * at.velocityY));
        thrown.step(0.5, 0, 0);

        assertThat(thrown.bodies.x[0]).isEqualTo(1 + 3 * way * 0.5, within(1e-13));
        assertThat(thrown.bodies.y[0]).isEqualTo(2 + 4 * way * 0.5, within(1e-13));
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(3 * speed, within(1e-13));
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(4 * speed, within(1e-13));
    }

    /**
     * In a spring of 4/s² Euler takes the acceleration at the start, Verlet the mean of both ends.
     */
    @ParameterizedTest
    @CsvSource({"EULER, 1, 0", "VERLET, 0.5, 0.5"})
    void theSimpleMethodsTakeTheMeanOfTheirPulls(Integrator method, double atStart, double atEnd) {
        Thrown thrown = new Thrown(Thrown.by(method), 0, at -> at.accelerate(-4 * at.x, -4 * at.y));
        thrown.step(0.5, 0, 0);

        // x₁ = x₀ + v₀h − 4x₀h²/2, or h² with Euler.
        double fall = method == Integrator.EULER ? 1 : 0.5;
        double x = 1 + 1.5 - fall;
        double y = 2 + 2 - 2 * fall;
        assertThat(thrown.bodies.x[0]).isEqualTo(x, within(1e-14));
        assertThat(thrown.bodies.y[0]).isEqualTo(y, within(1e-14));
        assertThat(thrown.bodies.velocityX[0])
                .isEqualTo(3 - 2 * (atStart + atEnd * x), within(1e-14));
        assertThat(thrown.bodies.velocityY[0])
                .isEqualTo(4 - 2 * (atStart * 2 + atEnd * y), within(1e-14));
    }
}
