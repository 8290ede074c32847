package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Choice;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Widget;

/** The pool does what the pendulum and the car predict. */
class JointDemosTest {

    private static final double STEP = 1.0 / 60;

    private final Words words = new Words("en");
    private Workbench bench;

    private <D extends Demo> D open(D demo) {
        bench = EveryDemo.built(demo);
        return demo;
    }

    private void run(Demo demo, double seconds) {
        for (int i = 0; i < Math.round(seconds / STEP); i++) {
            bench.pull();
            demo.beforeStep(bench);
            bench.step(STEP);
            demo.afterStep(bench);
        }
    }

    private static void set(Demo demo, String name, double value) {
        for (Widget widget : demo.widgets()) {
            if (widget instanceof Slider slider && slider.label().equals(name)) {
                slider.change().accept(value);
                return;
            }
        }
        throw new AssertionError("there is no slider " + name);
    }

    private static void choose(Demo demo, int option) {
        demo.widgets().stream()
                .filter(Choice.class::isInstance)
                .map(Choice.class::cast)
                .forEach(choice -> choice.change().accept(option));
    }

    /**
     * GAME's limit for a pendulum is a thousandth; a hinge of a small island is held by an equation
     * and integrated at order four, which leaves some 1e-6 at the steepest of these.
     */
    @ParameterizedTest
    @ValueSource(doubles = {2, 60, 90, 150, 175})
    void pendulumTakesTheTimeThatTheEllipticIntegralSays(double degrees) {
        PendulumDemo demo = open(new PendulumDemo(words));
        set(demo, "amplitude", degrees);
        run(demo, 20);
        double predicted = demo.predicted().orElseThrow();
        double measured = demo.measured().orElseThrow();
        assertThat(measured / predicted - 1).isCloseTo(0, within(1e-4));
        assertThat(demo.energyDrift()).isCloseTo(0, within(1e-4));
    }

    /** Fast enough it goes over the top, and takes the time that is said for that. */
    @Test
    void pendulumThatGoesRoundTakesTheTimeOfARound() {
        PendulumDemo demo = open(new PendulumDemo(words));
        set(demo, "amplitude", 0);
        RigidBody bob = demo.hang().last();
        bob.velocity(9, 0);
        bob.spin(9 / demo.hang().length);
        run(demo, 10);
        double predicted = demo.predicted().orElseThrow();
        assertThat(demo.measured().orElseThrow() / predicted - 1).isCloseTo(0, within(1e-4));
    }

    /** The mean over a step and that of its ends differ by (ω·dt)²/12, here 1e-4. */
    @Test
    void pinCarriesTheBobsPull() {
        PendulumDemo demo = open(new PendulumDemo(words));
        for (int second = 0; second < 5; second++) {
            run(demo, 1);
            double predicted = demo.pull().orElseThrow();
            assertThat(demo.tension().orElseThrow()).isCloseTo(predicted, within(1e-2));
        }
    }

    /** At rest the pin carries all that hangs; swinging, the chain keeps its length. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 2, 4})
    void chainCarriesItsWeightAndDoesNotStretch(double power) {
        PendulumDemo demo = open(new PendulumDemo(words));
        choose(demo, Hang.Kind.CHAIN.ordinal());
        set(demo, "mass ratio", power);
        set(demo, "amplitude", 0);
        run(demo, 1);
        double weight = demo.pull().orElseThrow();
        assertThat(demo.tension().orElseThrow() / weight).isCloseTo(1, within(1e-2));
        set(demo, "amplitude", 30);
        run(demo, 4);
        assertThat(demo.hang().stretch()).isLessThan(1e-3);
    }

    @ParameterizedTest
    @CsvSource({
        "en, 0, 1 ×", "en, 0.5, 3.2 ×", "en, 1.5, 32 ×", "en, 4, '10,000 ×'",
        "de, 0, 1 ×", "de, 0.5, '3,2 ×'", "de, 1.5, 32 ×", "de, 4, 10.000 ×"
    })
    void massesAreMultiplesInPlainNumbers(String language, double power, String shown) {
        Words told = new Words(language);
        PendulumDemo demo = open(new PendulumDemo(told));
        String ratio = told.of("pendulum.ratio");
        set(demo, ratio, power);
        assertThat(demo.widgets())
                .filteredOn(
                        widget -> widget instanceof Slider slider && slider.label().equals(ratio))
                .singleElement()
                .satisfies(
                        widget ->
                                assertThat(((Slider) widget).shown().apply(power))
                                        .isEqualTo(shown));
    }

    /** Switching off and on again hangs the pendulum anew. */
    @Test
    void whatWasTakenApartIsHungUpAgain() {
        for (Demo demo : new Demo[] {new PendulumDemo(words), new CarDemo(words)}) {
            open(demo);
            int joints = bench.pool().joints().size();
            Effects effects = bench.pool().effects();
            bench.haunt(true);
            bench.pool().effects(effects.without(Joints.class));
            run(demo, 0.5);
            assertThat(bench.pool().joints()).isEmpty();
            bench.pool().effects(effects);
            run(demo, 0.5);
            assertThat(bench.pool().joints()).hasSize(joints);
        }
    }

    /** A hand is a joint here: it brings the point that it holds to the pointer. */
    @Test
    void handHoldsABobWhereItWasGrabbed() {
        PendulumDemo demo = open(new PendulumDemo(words));
        RigidBody bob = demo.hang().last();
        int joints = bench.pool().joints().size();
        bench.grab(bob.x(), bob.y());
        assertThat(bench.pool().joints()).hasSize(joints + 1);
        double length = demo.hang().length;
        bench.point(-length, 0);
        run(demo, 5);
        // 5 Hz pull as strongly as 1,000 m/s² for each metre: the weight hangs 10 mm below.
        assertThat(bob.x()).isCloseTo(-length, within(1e-3));
        assertThat(bob.y()).isCloseTo(0, within(0.012));
        bench.letGo();
        assertThat(bench.pool().joints()).hasSize(joints);
    }

    /** Standing, wherever the load is: by the moments about the other wheel. */
    @ParameterizedTest
    @CsvSource({"60, -0.4", "300, 0.3", "300, -0.5", "10, 0"})
    void wheelsCarryWhatStaticsSays(double load, double place) {
        CarDemo demo = open(new CarDemo(words));
        set(demo, "wheels", 0);
        set(demo, "load", load);
        set(demo, "load at", place);
        run(demo, 5);
        assertThat(demo.car().speed()).isCloseTo(0, within(1e-3));
        for (double[] wheel : new double[][] {demo.rear(), demo.front()}) {
            assertThat(wheel[1] / wheel[0]).isCloseTo(1, within(0.01));
        }
        double sum = demo.rear()[1] + demo.front()[1];
        assertThat(sum / demo.car().weight()).isCloseTo(1, within(0.01));
    }

    /** Over the hill, the bridge and the see-saw, whose joints hold all the way. */
    @Test
    void carComesToTheEndOfTheTrack() {
        CarDemo demo = open(new CarDemo(words));
        double gap = 0;
        double sag = demo.track().sag();
        double deepest = sag;
        double lean = demo.track().lean();
        for (int i = 0; i < 40 && demo.car().chassis.x() < 52; i++) {
            run(demo, 1);
            gap = Math.max(gap, demo.track().gap());
            deepest = Math.max(deepest, demo.track().sag());
        }
        assertThat(demo.car().chassis.x()).isGreaterThan(52);
        assertThat(gap).isLessThan(1e-3);
        assertThat(deepest).isGreaterThan(sag);
        assertThat(demo.track().lean()).isLessThan(0).isLessThan(lean);
    }

    /** Started in its funicular polygon, the bridge stays in it. */
    @Test
    void bridgeHangsStill() {
        CarDemo demo = open(new CarDemo(words));
        set(demo, "wheels", 0);
        double sag = demo.track().sag();
        run(demo, 5);
        assertThat(demo.track().sag()).isCloseTo(sag, within(1e-4));
    }
}
