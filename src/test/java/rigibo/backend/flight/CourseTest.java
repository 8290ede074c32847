package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.force.ChangingForces;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Integrator;
import rigibo.backend.storage.Bodies;

/** Paths under forces that vary along the path, and paths that an impact cuts short. */
class CourseTest {

    /** Each awake dynamic body has a path of its own; sleeping and driven bodies have none. */
    @Test
    void everyAwakeDynamicBodyHasAPath() {
        Thrown thrown =
                new Thrown(Thrown.by(Integrator.RK4), 0, 20, at -> at.accelerate(6 * at.time, 0));
        thrown.step(1, 0, 0);

        for (int slot = 0; slot < 20; slot++) {
            assertThat(thrown.bodies.x[slot]).isEqualTo(5, within(1e-13));
            assertThat(thrown.bodies.velocityX[slot]).isEqualTo(6, within(1e-13));
        }
    }

    /**
     * The motion x = t³ is the cubic of the path itself. Cut at ¼ and laid again, it ends with the
     * same velocity. The place keeps the error of the laid parabola at ¼, σ²(1 − σ).
     */
    @ParameterizedTest
    @CsvSource({"1, 0", "0, 1", "-2, 1"})
    void aPathLaidAnewOnTheWayGoesOnAsItWas(double x, double y) {
        for (Integrator method : new Integrator[] {Integrator.RK4, Integrator.BALLISTIC}) {
            Thrown thrown =
                    new Thrown(
                            Thrown.by(method),
                            0,
                            at -> at.accelerate(6 * x * at.time, 6 * y * at.time));
            Bodies bodies = thrown.bodies;
            thrown.storage.data.time = 2;
            bodies.accelerationX[0] = 0;
            bodies.accelerationY[0] = 0.5;
            thrown.course.begin(1);
            OpenFlight flight = new OpenFlight(thrown.storage.data, null);
            flight.fly(0.25);
            thrown.course.catchUp(0, 0.25);
            thrown.course.lay(0, 0.25, 1);
            flight.fly(0.75);
            thrown.course.catchUp(0, 1);

            // The integral of 6t from 2 to 3 s is 15, and the integral of 3t² − 12 is 7.
            double off = 0.75 / 16;
            assertThat(bodies.x[0]).isEqualTo(1 + 3 + (7 + off) * x, within(1e-12));
            assertThat(bodies.y[0]).isEqualTo(2 + 4 + 0.25 + (7 + off) * y, within(1e-12));
            assertThat(bodies.velocityX[0]).isEqualTo(3 + 15 * x, within(1e-12));
            assertThat(bodies.velocityY[0]).isEqualTo(4 + 0.5 + 15 * y, within(1e-12));
            thrown.course.catchUp(0, 1);
            assertThat(bodies.velocityX[0]).as("only once").isEqualTo(3 + 15 * x, within(1e-12));
            assertThat(bodies.velocityY[0]).isEqualTo(4 + 0.5 + 15 * y, within(1e-12));
        }
    }

    /**
     * An impact at the start of a step sends a body into unbounded forces. It keeps its old path: a
     * body that is not finite would spread to all that it meets before the step ends.
     */
    @Test
    void aPathLaidAnewAtTheStartOfAStepStaysFinite() {
        Thrown thrown =
                new Thrown(
                        Thrown.by(Integrator.RK4),
                        0,
                        at -> at.accelerate(1 / (4 - at.velocityX), 0));
        thrown.step(0.01, 0, 0);
        thrown.bodies.velocityX[0] = 4;
        double before = thrown.bodies.accelerationX[0];
        thrown.course.lay(0, 0, 0.01);
        assertThat(thrown.bodies.accelerationX[0]).isFinite().isEqualTo(before);
        thrown.course.begin(0.01);
        assertThat(thrown.bodies.accelerationX[0]).as("for StepBodies to see").isNaN();
    }

    /**
     * Where a path is cut at ¼ of its length, the cubic differs by σ(3σ − 2) of the velocity that
     * the path lacks at its end.
     */
    @Test
    void whatIsMetOnTheWayHasTheVelocityOfTheCubic() {
        Accuracy accuracy = Thrown.by(Integrator.BALLISTIC);
        Field field = new Field(at -> at.accelerate(6 * at.time, 0));
        FilledStorage storage = new FilledStorage(accuracy, field, new Contacts());
        storage.add(BodyDefinition.dynamic(new Circle(1)).velocity(3, 0));
        ChangingForces forces = new ChangingForces(Effects.of(field, new Contacts()));
        Course course = new Course(storage.data, forces, accuracy);
        course.begin(1);
        Trajectories paths = new Trajectories(storage.bodies);
        paths.begin();
        assertThat(storage.bodies.accelerationX[0]).as("x = 1: a = 2").isEqualTo(2, within(1e-14));
        paths.advance(0, 0.25);
        course.catchUp(0, 0.25);

        // The velocity is 3 + 2·¼. The path lacks 3 − 2 = 1, of which the share is ¼·(¾ − 2).
        assertThat(storage.bodies.velocityX[0]).isEqualTo(3.5 - 0.3125, within(1e-14));
        double then = storage.bodies.velocityX[0];
        course.catchUp(0, 0.5);
        assertThat(storage.bodies.velocityX[0]).as("only once").isEqualTo(then);
    }

    /**
     * The acceleration by varying forces is stored apart from the constant one: piles read only it.
     */
    @Test
    void tellsThePullFromWhatIsSteady() {
        Thrown thrown = new Thrown(Thrown.by(Integrator.BALLISTIC), 2, at -> at.accelerate(5, 7));
        for (int i = 0; i < 2; i++) {
            thrown.bodies.accelerationX[0] = 1;
            thrown.bodies.accelerationY[0] = -8;
            thrown.course.begin(1e-3);
            // Exact to first order in k·h = 2·10⁻³.
            assertThat(thrown.bodies.pullX[0]).isEqualTo(5, within(0.02));
            assertThat(thrown.bodies.pullY[0]).isEqualTo(7, within(0.02));
            assertThat(thrown.bodies.accelerationX[0])
                    .isEqualTo(1 + thrown.bodies.pullX[0], within(1e-12));
            assertThat(thrown.bodies.accelerationY[0])
                    .isEqualTo(-8 + thrown.bodies.pullY[0], within(1e-12));
        }
    }

    /**
     * The bound is ten times the speed of light at the end of the path, and the distance covered at
     * that speed in 2 s.
     */
    @ParameterizedTest
    @CsvSource({"1.4e9, true", "1.6e9, false"})
    void whatIsBoundedIsLaid(double acceleration, boolean isBounded) {
        Thrown thrown =
                new Thrown(Thrown.by(Integrator.RK4), 0, at -> at.accelerate(acceleration, 0));
        thrown.bodies.accelerationX[0] = 0;
        thrown.course.begin(2);

        assertThat(Double.isNaN(thrown.bodies.accelerationX[0])).isNotEqualTo(isBounded);
    }

    @Test
    void aForceWithoutANumberIsToldAtTheStart() {
        Thrown thrown =
                new Thrown(Thrown.by(Integrator.BALLISTIC), 0, at -> at.accelerate(Double.NaN, 0));
        thrown.bodies.accelerationX[0] = 0;
        thrown.course.begin(0.5);

        assertThat(thrown.bodies.accelerationX[0]).isNaN();
    }

    @Test
    void aStepOfNoLengthChangesNothing() {
        Thrown thrown = new Thrown(Thrown.by(Integrator.BALLISTIC), 0, at -> at.accelerate(5, 7));
        thrown.step(0, 0.5, -8);

        assertThat(thrown.bodies.x[0]).isEqualTo(1);
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(3);
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(4);
        assertThat(thrown.bodies.accelerationX[0]).isEqualTo(0.5);
    }

    @Test
    void aPathOfNoLengthChangesNothing() {
        Thrown thrown = new Thrown(Thrown.by(Integrator.BALLISTIC), 0, at -> at.accelerate(5, 7));
        thrown.course.begin(1);
        double before = thrown.bodies.accelerationX[0];
        thrown.course.lay(0, 1, 1);
        thrown.course.catchUp(0, 1);

        assertThat(thrown.bodies.accelerationX[0]).isEqualTo(before);
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(3);
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(4);
    }
}
