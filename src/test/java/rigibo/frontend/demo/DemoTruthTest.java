package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Toggle;
import rigibo.frontend.scene.widget.Widget;

/** The pool does what the demos predict, at all settings of their controls. */
class DemoTruthTest {

    private static final double STEP = 1.0 / 60;

    /** A step of {@code GAME} places a body to the micrometre; a tenth of a millimetre is seen. */
    private static final double SEEN = 1e-4;

    /** Ice at 8 m/s slides for 8/(0.03·g) = 27.2 s. */
    private static final int LONGEST = 28 * 60;

    private static void run(Demo demo, Workbench bench, int steps) {
        for (int i = 0; i < steps; i++) {
            demo.beforeStep(bench);
            bench.pool().step(STEP);
            demo.afterStep(bench);
        }
    }

    private static void set(Demo demo, String words, double value) {
        for (Widget widget : demo.widgets()) {
            if (widget instanceof Slider slider && slider.label().equals(words)) {
                slider.change().accept(value);
                return;
            }
        }
        throw new AssertionError("there is no slider " + words);
    }

    private static void flip(Demo demo, String words) {
        for (Widget widget : demo.widgets()) {
            if (widget instanceof Toggle toggle && toggle.words().equals(words)) {
                toggle.flip().run();
                return;
            }
        }
        throw new AssertionError("there is no switch " + words);
    }

    @ParameterizedTest
    @CsvSource({"0, 5", "0, 8", "1, 8", "20, 3", "30, 8", "43, 6", "60, 1", "60, 8"})
    void boxesComeAsFarAsCoulombsLawSays(double degrees, double speed) {
        FrictionDemo demo = new FrictionDemo(new Words("en"));
        Workbench bench = EveryDemo.built(demo);
        set(demo, "speed", speed);
        set(demo, "ramp", degrees);
        run(demo, bench, LONGEST);
        for (Lane lane : demo.lanes()) {
            assertThat(lane.hasTurned()).isTrue();
            assertThat(lane.farthest()).as(lane.name).isCloseTo(lane.predicted(), within(SEEN));
            boolean isWhereItTurned = Math.abs(lane.gone() - lane.farthest()) < SEEN;
            assertThat(isWhereItTurned).as("%s holds", lane.name).isEqualTo(lane.holds());
        }
    }

    /** All that a box that stays where it stopped had is heat, less what its height holds. */
    @Test
    void heatIsWhatTheLaunchLost() {
        FrictionDemo demo = new FrictionDemo(new Words("en"));
        Workbench bench = EveryDemo.built(demo);
        run(demo, bench, LONGEST);
        for (Lane lane : demo.lanes()) {
            assertThat(lane.heat()).isCloseTo(10 * 5 * 5 / 2.0, within(1e-3));
        }
    }

    /** Rolling, slipping, driven, thrust, with rolling resistance, as a disc and as a hoop. */
    @ParameterizedTest
    @CsvSource({
        "15, 0.6, 0, 0, 0, false", "15, 0.6, 0, 0, 0, true", "45, 0.1, 0, 0, 0, false",
        "10, 0.6, 10, 0, 0, true", "5, 0.6, 0, 20, 40, false", "0, 0.05, 0, 60, 0, false",
        "20, 0.6, 20, -10, 0, false", "1, 0.6, 20, 0, 0, false", "30, 0, 0, 0, 30, true"
    })
    void wheelAcceleratesAsTheFormulaSays(
            double ramp,
            double friction,
            double lever,
            double torque,
            double thrust,
            boolean isHoop) {
        WheelDemo demo = new WheelDemo(new Words("en"));
        Workbench bench = EveryDemo.built(demo);
        set(demo, "ramp", ramp);
        set(demo, "friction", friction);
        set(demo, "rolling c", lever);
        set(demo, "torque", torque);
        set(demo, "thrust", thrust);
        if (isHoop) {
            flip(demo, "hoop");
        }
        // Settled after a step; while it slips or rolls one way nothing changes.
        run(demo, bench, 2);
        for (int i = 0; i < 50; i++) {
            run(demo, bench, 1);
            double[] accelerations = demo.accelerations();
            assertThat(accelerations[1]).isCloseTo(accelerations[0], within(1e-3));
        }
    }

    /**
     * The brake locks the wheel, which slides to a stand, and holds it there. The formula is that
     * of the beginning of a step: it need not be true in the one step within which the wheel stops.
     */
    @Test
    void brakeStopsAndHoldsTheWheel() {
        WheelDemo demo = new WheelDemo(new Words("en"));
        Workbench bench = EveryDemo.built(demo);
        run(demo, bench, 60);
        flip(demo, "brake");
        int others = 0;
        for (int i = 0; i < 180; i++) {
            run(demo, bench, 1);
            double[] accelerations = demo.accelerations();
            others += Math.abs(accelerations[1] - accelerations[0]) > 1e-3 ? 1 : 0;
        }
        assertThat(others).isLessThanOrEqualTo(1);
        assertThat(bench.pool().kineticEnergy()).isLessThan(1e-9);
    }
}
