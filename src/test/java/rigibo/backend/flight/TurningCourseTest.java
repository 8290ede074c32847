package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.force.ChangingForces;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Integrator;
import rigibo.backend.storage.Bodies;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * The turning of bodies by forces that vary along the path. In water of 1 kg/m² a submerged disc of
 * radius 1 m loses d·J of its spin and d·A of its velocity, with A = π and J = π/2; a floating box
 * rocks.
 */
class TurningCourseTest {

    private static final double G = 8;
    private static final double INERTIA = 2;
    private static final double MASS = 4;

    /** The drag that gives ω' = α − κ·ω with this κ, in 1/s. */
    private static double dragFor(double kappa) {
        return kappa * INERTIA / (Math.PI / 2);
    }

    private static Accuracy by(Integrator method) {
        return Accuracy.DRAFT.withIntegrator(method);
    }

    /** Bodies in water whose weight equals that of the water they displace. */
    private static final class Diving {

        final FilledStorage storage;
        final Bodies bodies;
        final Course course;
        final OpenFlight flight;

        Diving(Accuracy accuracy, double drag, Effect... more) {
            Effect[] effects = {
                new Gravity(0, -G), new Buoyancy(100, 1, drag), new Rotation(),
            };
            Effect[] all = new Effect[3 + more.length];
            System.arraycopy(effects, 0, all, 0, 3);
            System.arraycopy(more, 0, all, 3, more.length);
            storage = new FilledStorage(accuracy, all);
            bodies = storage.bodies;
            course = new Course(storage.data, new ChangingForces(Effects.of(all)), accuracy);
            flight = new OpenFlight(storage.data, course);
        }

        int add(Shape shape, double y) {
            return storage.add(
                    BodyDefinition.dynamic(shape).mass(MASS).inertia(INERTIA).at(0, y).spin(3));
        }

        void lay(double dt, double accelerationY, double angular) {
            for (int slot = 0; slot < bodies.slots.high; slot++) {
                bodies.accelerationX[slot] = 0;
                bodies.accelerationY[slot] = accelerationY;
                bodies.angularAcceleration[slot] = angular;
            }
            course.begin(dt);
        }

        void step(double dt, double accelerationY, double angular) {
            lay(dt, accelerationY, angular);
            flight.fly(dt);
            storage.data.time += dt;
        }
    }

    /** ω(t) = α/κ + (ω₀ − α/κ)·e^(−κt) from ω₀ = 3. */
    private static double spin(double kappa, double alpha, double time) {
        return alpha / kappa + (3 - alpha / kappa) * Math.exp(-kappa * time);
    }

    /** Its integral, from θ₀ = 0. */
    private static double angle(double kappa, double alpha, double time) {
        double gone = (1 - Math.exp(-kappa * time)) / kappa;
        return alpha / kappa * time + (3 - alpha / kappa) * gone;
    }

    private static double error(Integrator method, int steps) {
        double kappa = 1.5;
        double alpha = -7;
        Diving diving = new Diving(by(method), dragFor(kappa));
        diving.add(new Circle(1), 0);
        for (int i = 0; i < steps; i++) {
            diving.step(1.0 / steps, -G, alpha);
        }
        return Math.hypot(
                diving.bodies.angle[0] - angle(kappa, alpha, 1),
                diving.bodies.spin[0] - spin(kappa, alpha, 1));
    }

    @ParameterizedTest
    @CsvSource({"EULER, 1", "VERLET, 2", "RK4, 4", "BALLISTIC, 4"})
    void aSpinUnderWaterDecaysWithTheOrderOfTheMethod(Integrator method, int order) {
        double coarse = error(method, 32);
        double fine = error(method, 64);

        assertThat(Math.log(coarse / fine) / Math.log(2)).isEqualTo(order, within(0.15));
        assertThat(fine).as("of the size of h to the order").isLessThan(10 * Math.pow(0.02, order));
    }

    /** Angle, spin and height of a tilted floating box after a quarter of a second. */
    private static double[] rocked(Integrator method, int steps) {
        Diving diving = new Diving(by(method), 0.5);
        // 4 m wide and 2 m high, with its centre just above the water level, which two sides always
        // cross.
        int box = diving.add(Polygon.box(4, 2), 100.1);
        diving.bodies.turn(box, 0.1);
        diving.bodies.spin[box] = 0.2;
        for (int i = 0; i < steps; i++) {
            diving.step(0.25 / steps, -G, 0.3);
        }
        Bodies bodies = diving.bodies;
        return new double[] {bodies.angle[box], bodies.spin[box], bodies.y[box]};
    }

    /** A torque that depends on the angle: halving the step divides the error by 2ᵖ or more. */
    @ParameterizedTest
    @CsvSource({"EULER, 1", "VERLET, 2", "RK4, 4", "BALLISTIC, 4"})
    void aFloatingBoxRocksWithTheOrderOfTheMethod(Integrator method, int order) {
        double[] coarse = rocked(method, 8);
        double[] fine = rocked(method, 16);
        double[] finer = rocked(method, 32);
        for (int i = 0; i < 3; i++) {
            double ratio = Math.abs((coarse[i] - fine[i]) / (fine[i] - finer[i]));
            assertThat(Math.log(ratio) / Math.log(2))
                    .as("number %d of angle, spin, height", i)
                    .isGreaterThan(order - 0.3);
        }
    }

    /** Under a constant torque and no force: θ = ωt + ½αt² at any step. */
    @ParameterizedTest
    @EnumSource(
            value = Integrator.class,
            names = {"RK4", "BALLISTIC"})
    void outOfTheWaterAllIsSteady(Integrator method) {
        Diving diving = new Diving(by(method), 0.5);
        diving.add(new Circle(1), 200);
        diving.step(0.5, 0, 4);

        assertThat(diving.bodies.angle[0]).isEqualTo(1.5 + 0.5, within(1e-14));
        assertThat(diving.bodies.spin[0]).isEqualTo(5, within(1e-14));
        assertThat(diving.bodies.y[0]).isEqualTo(200);
    }

    /**
     * Over ¼ s the spin ends after 3/κ rad, for a disc too heavy to lose speed. A drag of 400/s
     * takes substeps, and is right to the thousandths that their h allows. One of 10⁷/s is too
     * stiff for any substep: it stops the body at once and does not throw it back.
     */
    @ParameterizedTest
    @CsvSource({
        "RK4, 400, 0.004",
        "RK4, 1e7, 1.01",
        "BALLISTIC, 400, 0.004",
        "BALLISTIC, 1e7, 1.01"
    })
    void aStiffTorqueEndsTheSpin(Integrator method, double kappa, double off) {
        Diving diving = new Diving(by(method), dragFor(kappa));
        diving.add(new Circle(1), 0);
        diving.bodies.inverseMass[0] = 1e-12;
        diving.step(0.25, 0, 0);

        double angle = 3 / kappa;
        assertThat(diving.bodies.angle[0]).isEqualTo(angle, within(off * angle));
        assertThat(diving.bodies.spin[0]).isEqualTo(0, within(1e-6));
    }

    /**
     * As many substeps as for a linear drag: κT = 9.5 takes ten, with four evaluations each but the
     * first.
     */
    @Test
    void aStiffTorqueTakesAsManySubstepsAsADrag() {
        AtomicInteger looks = new AtomicInteger();
        Field counting = new Field(at -> looks.incrementAndGet());
        Diving diving = new Diving(by(Integrator.RK4), dragFor(19), counting);
        diving.add(new Circle(1), 0);
        diving.bodies.inverseMass[0] = 0;
        diving.step(0.5, 0, 0);

        assertThat(looks.get()).isEqualTo(2 + 3 * 10 + 9);
    }

    /**
     * Where the path is cut at a share σ of its length, it has the spin of the cubic through both
     * ends. With θ₁ the angle turned in T, and ω₀ and ω₁ the spins at both ends, that is σ(1 −
     * σ)·6·θ₁/T + (1 − σ)(1 − 3σ)·ω₀ − σ(2 − 3σ)·ω₁.
     */
    @Test
    void whatIsMetOnTheWayHasTheSpinOfTheCubic() {
        double kappa = 1.5;
        Accuracy accuracy = by(Integrator.BALLISTIC).withSubsteps(64);
        Diving diving = new Diving(accuracy, dragFor(kappa), new Contacts());
        diving.add(new Circle(1), 0);
        diving.lay(0.5, -G, 0);
        Trajectories paths = new Trajectories(diving.bodies);
        paths.begin();
        paths.advance(0, 0.125);
        diving.course.catchUp(0, 0.125);

        double first = 0.75 * 0.25 * 6 * angle(kappa, 0, 0.5) / 0.5;
        double cubic = first + 0.75 * 0.25 * 3 - 0.25 * 1.25 * spin(kappa, 0, 0.5);
        assertThat(diving.bodies.spin[0]).isEqualTo(cubic, within(1e-8));
        diving.course.catchUp(0, 0.25);
        assertThat(diving.bodies.spin[0]).as("only once").isEqualTo(cubic, within(1e-8));
    }

    /**
     * The water's torque is −κ·ω to first order; it is stored apart from the constant torque in
     * every step.
     */
    @Test
    void tellsTheTorqueOfTheWaterFromWhatIsSteady() {
        Diving diving = new Diving(by(Integrator.BALLISTIC), dragFor(1.5));
        for (int i = 0; i < 20; i++) {
            diving.add(new Circle(1), 0);
        }
        for (int i = 0; i < 2; i++) {
            diving.lay(1e-3, -G, 0.25);
            for (int slot = 0; slot < 20; slot++) {
                assertThat(diving.bodies.pullTurn[slot]).isEqualTo(-4.5, within(0.01));
                assertThat(diving.bodies.angularAcceleration[slot])
                        .isEqualTo(0.25 + diving.bodies.pullTurn[slot], within(1e-12));
            }
        }
    }

    /** A path laid again from the same place is the same: the water's torque is not constant. */
    @Test
    void aPathLaidAgainIsTheSame() {
        Diving diving = new Diving(by(Integrator.BALLISTIC), dragFor(1.5));
        diving.add(new Circle(1), 0);
        diving.lay(0.25, -G, 0.25);
        double before = diving.bodies.angularAcceleration[0];
        diving.course.lay(0, 0, 0.25);
        assertThat(diving.bodies.angularAcceleration[0]).isEqualTo(before, within(1e-14));
    }

    /** A submerged disc at rest lacks spin only, not velocity. */
    @Test
    void whatOnlyTurnsCatchesUpOnce() {
        double kappa = 1.5;
        Diving diving = new Diving(by(Integrator.RK4).withSubsteps(64), dragFor(kappa));
        diving.add(new Circle(1), 0);
        diving.bodies.inverseMass[0] = 0;
        diving.step(0.5, 0, 0);
        assertThat(diving.bodies.velocityY[0]).isZero();
        assertThat(diving.bodies.spin[0]).isEqualTo(spin(kappa, 0, 0.5), within(1e-8));
        diving.course.catchUp(0, 0.5);
        assertThat(diving.bodies.spin[0]).isEqualTo(spin(kappa, 0, 0.5), within(1e-8));
    }

    /** A path of length 0 takes back nothing that another path lacked, and lacks nothing itself. */
    @Test
    void aPathOfNoLengthLacksNoSpin() {
        Diving diving = new Diving(by(Integrator.RK4), dragFor(1.5));
        diving.add(new Circle(1), 0);
        diving.lay(0.5, -G, 0);
        diving.course.lay(0, 0.5, 0.5);
        diving.course.catchUp(0, 0.5);
        assertThat(diving.bodies.spin[0]).isEqualTo(3);
        assertThat(diving.bodies.velocityY[0]).isZero();
    }

    /** Flyers among contacts are corrected, too; bodies of piles are not. */
    @Test
    void flyersCatchUpWithWhatTheirPathsLack() {
        double kappa = 1.5;
        Accuracy accuracy = by(Integrator.RK4).withSubsteps(64);
        Diving diving = new Diving(accuracy, dragFor(kappa), new Contacts());
        diving.add(new Circle(1), 0);
        diving.add(new Circle(1), 10);
        diving.bodies.piled[1] = true;
        diving.lay(0.5, -G, 0);
        new FreeFlight(diving.storage.data, diving.course).fly(0.5);

        assertThat(diving.bodies.angle[0]).isEqualTo(angle(kappa, 0, 0.5), within(1e-8));
        assertThat(diving.bodies.spin[0]).isEqualTo(spin(kappa, 0, 0.5), within(1e-8));
        assertThat(diving.bodies.spin[1]).isEqualTo(3);
    }
}
