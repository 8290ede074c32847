package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Integrator;
import rigibo.backend.setup.Material;

/** How the error of each integrator shrinks with the step. */
class IntegratorTest {

    /** ω of the spring: one turn per second. */
    private static final double OMEGA = 2 * Math.PI;

    /** Not a whole number of periods, at which some errors vanish by chance. */
    private static final double HORIZON = 1.25;

    /**
     * Distance in m from x = e^(−kt/2)·(cos w + k/2Ω·sin w), y = e^(−kt/2)·ω/Ω·sin w with Ω² = ω² −
     * k²/4 and w = Ωt, which is where a spring with drag k takes what starts at (1, 0) with (0, ω).
     */
    private static double error(Accuracy accuracy, double drag, int stepsPerSecond) {
        Field spring = new Field(at -> at.accelerate(-OMEGA * OMEGA * at.x, -OMEGA * OMEGA * at.y));
        Pool pool = new Pool(Effects.of(spring, new Drag()), accuracy);
        RigidBody ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.1))
                                .at(1, 0)
                                .velocity(0, OMEGA)
                                .material(Material.DEFAULT.drag(drag)));
        for (int i = 0; i < HORIZON * stepsPerSecond; i++) {
            pool.step(1.0 / stepsPerSecond);
        }
        double left = Math.exp(-drag / 2 * HORIZON);
        double damped = Math.sqrt(OMEGA * OMEGA - drag * drag / 4);
        double sin = Math.sin(damped * HORIZON);
        double x = left * (Math.cos(damped * HORIZON) + drag / 2 / damped * sin);
        double y = left * OMEGA / damped * sin;
        return Math.hypot(ball.x() - x, ball.y() - y);
    }

    /** p = log₂(error(h)/error(h/2)); what is beyond the leading term is of the order of h. */
    @ParameterizedTest(name = "{0} with drag {1} is of order {2}")
    @CsvSource({
        "EULER, 0, 1",
        "EULER, 1, 1",
        "VERLET, 0, 2",
        "VERLET, 1, 2",
        "RK4, 0, 4",
        "RK4, 1, 4",
        "BALLISTIC, 0, 4",
        "BALLISTIC, 1, 4"
    })
    void errorShrinksWithThePowerOfTheOrder(Integrator method, double drag, int order) {
        Accuracy accuracy = Accuracy.DRAFT.withIntegrator(method);
        double coarse = error(accuracy, drag, 128);
        double fine = error(accuracy, drag, 256);
        assertThat(Math.log(coarse / fine) / Math.log(2)).isEqualTo(order, within(0.05));
    }

    /** Substeps of a path are steps: four of them leave a 4⁴th of the error. */
    @Test
    void substepsCountAsSteps() {
        double one = error(Accuracy.DRAFT, 0, 64);
        double four = error(Accuracy.DRAFT.withSubsteps(4), 0, 64);
        assertThat(Math.log(one / four) / Math.log(4)).isEqualTo(4, within(0.05));
    }

    /** y = −gt²/2: exact for all but symplectic Euler, which is g·h·t/2 too low. */
    @ParameterizedTest
    @EnumSource(Integrator.class)
    void fallsAsItsRuleSays(Integrator method) {
        Accuracy accuracy = Accuracy.DRAFT.withIntegrator(method);
        Pool pool = new Pool(Effects.of(new Gravity(0, -9.81)), accuracy);
        RigidBody ball = pool.add(BodyDefinition.dynamic(new Circle(0.1)));
        Scenes.run(pool, 120);
        double tooLow = method == Integrator.EULER ? 9.81 * Scenes.DT * 2 / 2 : 0;
        assertThat(ball.y()).isEqualTo(-9.81 * 2 - tooLow, within(1e-11));
        assertThat(ball.velocityY()).isEqualTo(-9.81 * 2, within(1e-11));
    }
}
