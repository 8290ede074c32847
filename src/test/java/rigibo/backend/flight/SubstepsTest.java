package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.FieldFunction;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.Integrator;

import java.util.concurrent.atomic.AtomicInteger;

/** The number of substeps of a path, by the stiffness of its forces. */
class SubstepsTest {

    @ParameterizedTest
    @EnumSource(
            value = Integrator.class,
            names = {"EULER", "VERLET", "RK4"})
    void substepsAreStepsOfAPath(Integrator method) {
        Accuracy four = Thrown.by(method).withSubsteps(4);
        Thrown once = new Thrown(four, 0, at -> at.accelerate(-4 * at.x, -4 * at.y));
        Thrown often = new Thrown(Thrown.by(method), 0, at -> at.accelerate(-4 * at.x, -4 * at.y));
        once.step(0.5, 0, 0);
        for (int i = 0; i < 4; i++) {
            often.step(0.125, 0, 0);
        }

        assertThat(once.bodies.x[0]).isEqualTo(often.bodies.x[0], within(1e-14));
        assertThat(once.bodies.velocityY[0]).isEqualTo(often.bodies.velocityY[0], within(1e-14));
    }

    /**
     * A field's drag of 400/s over ¼ s: one step of an explicit method would overshoot a
     * hundredfold. In substeps the body stops v/k farther on, within a thousandth, the error of
     * their h.
     */
    @ParameterizedTest
    @EnumSource(
            value = Integrator.class,
            names = {"RK4", "BALLISTIC"})
    void aStiffForceIsTakenInSubsteps(Integrator method) {
        Thrown thrown =
                new Thrown(
                        Thrown.by(method),
                        0,
                        at -> at.accelerate(-400 * at.velocityX, -400 * at.velocityY));
        thrown.step(0.25, 0, 0);

        assertThat(thrown.bodies.x[0]).isEqualTo(1 + 3.0 / 400, within(3e-5));
        assertThat(thrown.bodies.y[0]).isEqualTo(2 + 4.0 / 400, within(4e-5));
        assertThat(Math.abs(thrown.bodies.velocityX[0])).isLessThan(1e-3);
        assertThat(Math.abs(thrown.bodies.velocityY[0])).isLessThan(1e-3);
    }

    /** A drag of 10⁷/s is too stiff for any substep: it stops the body and never throws it back. */
    @Test
    void whatIsTooStiffBrakesWithoutOvershooting() {
        Thrown thrown =
                new Thrown(
                        Thrown.by(Integrator.BALLISTIC),
                        0,
                        at -> at.accelerate(-1e7 * at.velocityX, -1e7 * at.velocityY));
        thrown.step(0.25, 0, 0);

        // The first substep takes all of the velocity, and no more.
        assertThat(thrown.bodies.x[0]).isEqualTo(1, within(1e-9));
        assertThat(thrown.bodies.y[0]).isEqualTo(2, within(1e-9));
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(0, within(1e-6));
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(0, within(1e-6));
    }

    /**
     * At most 1024 substeps: each evaluates the field three times on its way, and twice where it
     * starts or brakes.
     */
    @Test
    void whatIsTooStiffTakesNoMoreThan1024Substeps() {
        int looks =
                looks(
                        Thrown.by(Integrator.RK4),
                        at -> at.accelerate(-1e7 * at.velocityX, -1e7 * at.velocityY));

        assertThat(looks).isBetween(1024 * (3 + 1), 1 + 1024 * (3 + 2));
    }

    /**
     * A medium accelerates by 4 m/s². A body with a drag too stiff for any substep h keeps up with
     * it, within 2·4·h.
     */
    @Test
    void whatIsTooStiffKeepsUpWithWhatCarriesIt() {
        Thrown thrown = thrownInto(at -> at.accelerate(-1e7 * (at.velocityX - 4 * at.time), 0));

        assertThat(thrown.bodies.velocityX[0]).isEqualTo(1, within(2 * 4 * 0.25 / 1024));
    }

    /**
     * A medium moves along with the body, until after two substeps h it jumps from 3 to 13 m/s. It
     * carries the body along with the force of a drag ten times over in each substep, from the
     * place where the jump is found.
     */
    @Test
    void whatIsTooStiffIsTakenAlongAtOnce() {
        double h = 0.25 / 1024;
        Thrown thrown =
                thrownInto(
                        at -> {
                            double medium = at.time < 1.25 * h ? 3 : 13;
                            at.accelerate(10 / h * (medium - at.velocityX), 0);
                        });

        assertThat(thrown.bodies.x[0]).isEqualTo(1 + 3 * 2 * h + 13 * (0.25 - 2 * h), within(1e-9));
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(13, within(1e-9));
    }

    /** In equilibrium with a spring of 400/s² it is braked to −400·x/10⁷ m/s, for ¼ s. */
    @Test
    void whatIsTooStiffIsBrakedWhereItIs() {
        Thrown thrown = thrownInto(at -> at.accelerate(-1e7 * at.velocityX - 400 * at.x, 0));

        assertThat(thrown.bodies.x[0]).isEqualTo(1 - 400 * 0.25 / 1e7, within(1e-6));
    }

    /**
     * For one substep of h = ¼ s/1024 a force gains twice the body's speed per h, too stiff for any
     * substep. It is no drag, so nothing brakes: the body goes on three times as fast.
     */
    @Test
    void whatIsDrivenTooFastIsNotBraked() {
        double h = 0.25 / 1024;
        Thrown thrown =
                thrownInto(
                        at -> {
                            double rate = at.time < 0.75 * h ? 2 / h : 0;
                            at.accelerate(rate * at.velocityX, rate * at.velocityY);
                        });

        assertThat(thrown.bodies.velocityX[0]).isEqualTo(3 * 3, within(1e-12));
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(3 * 4, within(1e-12));
        assertThat(thrown.bodies.x[0]).isEqualTo(1 + 3 * 3 * 0.25, within(1e-12));
        assertThat(thrown.bodies.y[0]).isEqualTo(2 + 3 * 4 * 0.25, within(1e-12));
    }

    /** A body thrown for a quarter of a second into a field too stiff for any substep. */
    private static Thrown thrownInto(FieldFunction field) {
        Thrown thrown = new Thrown(Thrown.by(Integrator.RK4), 0, field);
        thrown.step(0.25, 0, 0);
        return thrown;
    }

    /** Number of evaluations of the field in a step of ½ s from (1, 2) at (3, 4) m/s. */
    private static int looks(Accuracy accuracy, FieldFunction field) {
        AtomicInteger looks = new AtomicInteger();
        FieldFunction counted =
                at -> {
                    looks.incrementAndGet();
                    field.act(at);
                };
        new Thrown(accuracy, 0, counted).step(0.5, 0, 0);
        return looks.get();
    }

    /**
     * One evaluation at the start and one a thousandth ahead measure the stiffness. Each of n
     * substeps takes three more, and each but the first one at its start. A drag with k·T = 9.5
     * takes ten substeps.
     */
    @ParameterizedTest
    @CsvSource({"1.9, 1, 1", "19, 1, 10", "19, 16, 16", "0, 3, 3"})
    void dragTakesAsManySubstepsAsItIsStiff(double k, int told, int substeps) {
        Accuracy accuracy = Thrown.by(Integrator.RK4).withSubsteps(told);
        int looks = looks(accuracy, at -> at.accelerate(-k * at.velocityX, -k * at.velocityY));

        assertThat(looks).isEqualTo(2 + 3 * substeps + (substeps - 1));
    }

    /** A drag of 19/s is as stiff near its equilibrium as far from it. */
    @Test
    void nearItsBalanceADragIsAsStiff() {
        int looks =
                looks(
                        Thrown.by(Integrator.RK4),
                        at ->
                                at.accelerate(
                                        -19 * (at.velocityX - 2.999),
                                        -19 * (at.velocityY - 3.999)));
        assertThat(looks).isEqualTo(2 + 3 * 10 + 9);
    }

    /**
     * A spring with ωT = 3 starts where its force does not change to first order. The evaluations
     * at the middle differ by (ωh/2)², which is more than a quarter with one substep and with two.
     * The path is integrated again with four.
     */
    @Test
    void aSpringTakesTwiceAsManyUntilTheMiddlesAgree() {
        int looks =
                looks(
                        Thrown.by(Integrator.RK4),
                        at ->
                                at.accelerate(
                                        -36 * (at.x - 1 - 3 * at.time - 1),
                                        -36 * (at.y - 2 - 4 * at.time - 1)));

        assertThat(looks).isEqualTo(2 + 3 + 1 + 3 + 1 + 4 * 3 + 3);
    }
}
