package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.FieldFunction;
import rigibo.backend.force.ChangingForces;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Integrator;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;

/** Paths under forces that change along the way, against closed forms. */
class CourseTest {

    /** A disc of 1 kg that flies through fields, without the rest of a step. */
    private static final class Thrown {

        final FilledStorage storage;
        final Bodies bodies;
        final Course course;
        final OpenFlight flight;

        Thrown(Accuracy accuracy, double drag, FieldFunction... fields) {
            this(accuracy, drag, 1, fields);
        }

        Thrown(Accuracy accuracy, double drag, int count, FieldFunction... fields) {
            FieldFunction all =
                    at -> {
                        for (FieldFunction field : fields) {
                            field.act(at);
                        }
                    };
            Effect[] effects = {new Field(all), new Drag()};
            storage = new FilledStorage(accuracy, effects);
            bodies = storage.bodies;
            for (int i = 0; i < count; i++) {
                storage.add(
                        BodyDefinition.dynamic(new Circle(1))
                                .mass(1)
                                .at(1, 2)
                                .velocity(3, 4)
                                .material(Material.DEFAULT.drag(drag)));
            }
            Effects declared = Effects.of(effects);
            course = new Course(storage.data, new ChangingForces(declared), accuracy);
            flight = new OpenFlight(storage.data, course);
        }

        /** As the stages of a step do, under steady accelerations beside the fields. */
        void step(double dt, double ax, double ay) {
            for (int slot = 0; slot < bodies.slots.high; slot++) {
                bodies.accelerationX[slot] = ax;
                bodies.accelerationY[slot] = ay;
            }
            course.begin(dt);
            flight.fly(dt);
            storage.data.time += dt;
        }
    }

    private static Accuracy by(Integrator method) {
        return Accuracy.DRAFT.withIntegrator(method);
    }

    /**
     * What a blow at the very start of a step sends into forces beyond all bounds goes on as it
     * was: who is not finite then would spread to all that it meets before the step ends.
     */
    @Test
    void aPathLaidAnewAtTheStartOfAStepStaysFinite() {
        Thrown thrown =
                new Thrown(by(Integrator.RK4), 0, at -> at.accelerate(1 / (4 - at.velocityX), 0));
        thrown.step(0.01, 0, 0);
        thrown.bodies.velocityX[0] = 4;
        double before = thrown.bodies.accelerationX[0];
        thrown.course.lay(0, 0, 0.01);
        assertThat(thrown.bodies.accelerationX[0]).isFinite().isEqualTo(before);
        thrown.course.begin(0.01);
        assertThat(thrown.bodies.accelerationX[0]).as("for the ledger").isNaN();
    }

    /**
     * x = x₀ + v₀t + jt³/6, v = v₀ + jt²/2: what grows with time is exact for a method of order 4.
     */
    @ParameterizedTest
    @EnumSource(
            value = Integrator.class,
            names = {"RK4", "BALLISTIC"})
    void aForceThatGrowsGivesACubic(Integrator method) {
        Thrown thrown = new Thrown(by(method), 0, at -> at.accelerate(6 * at.time, -12 * at.time));
        thrown.step(0.5, 0, 0);
        thrown.step(0.5, 0, 0);

        assertThat(thrown.bodies.x[0]).isEqualTo(1 + 3 + 1, within(1e-13));
        assertThat(thrown.bodies.y[0]).isEqualTo(2 + 4 - 2, within(1e-13));
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(3 + 3, within(1e-13));
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(4 - 6, within(1e-13));
    }

    /** What is steady is exact with every method but symplectic Euler, which is a·h·t/2 ahead. */
    @ParameterizedTest
    @EnumSource(Integrator.class)
    void aSteadyPullIsAParabola(Integrator method) {
        Thrown thrown = new Thrown(by(method), 0, at -> at.accelerate(0, 0));
        thrown.step(0.5, 0.5, -8);

        double ahead = method == Integrator.EULER ? 0.25 / 2 : 0;
        assertThat(thrown.bodies.x[0]).isEqualTo(2.5625 + 0.5 * ahead, within(1e-14));
        assertThat(thrown.bodies.y[0]).isEqualTo(3 - 8 * ahead, within(1e-14));
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(3.25, within(1e-14));
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(0, within(1e-14));
    }

    /** Under drag and a steady pull the exponential solution, which nothing is added to. */
    @Test
    void ballisticIsExactUnderDrag() {
        Thrown thrown = new Thrown(by(Integrator.BALLISTIC), 2, at -> at.accelerate(0, 0));
        thrown.step(0.5, 0.5, -8);

        double e1 = (1 - Math.exp(-1)) / 2;
        double e2 = (0.5 - e1) / 2;
        assertThat(thrown.bodies.x[0]).isEqualTo(1 + 3 * e1 + 0.5 * e2, within(1e-14));
        assertThat(thrown.bodies.y[0]).isEqualTo(2 + 4 * e1 - 8 * e2, within(1e-14));
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(-4 + 8 * Math.exp(-1), within(1e-14));
    }

    /** A spring ω = 2 with drag k: a damped oscillation about a place that a steady pull moves. */
    private static double error(Integrator method, double drag, int steps) {
        Thrown thrown = new Thrown(by(method), drag, at -> at.accelerate(-4 * at.x, -4 * at.y));
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

    /** p = log₂(error(h)/error(h/2)), within what the next term adds at h = 1/50 s. */
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

    @Test
    void substepsAreStepsOfAPath() {
        Accuracy four = by(Integrator.RK4).withSubsteps(4);
        Thrown once = new Thrown(four, 0, at -> at.accelerate(-4 * at.x, -4 * at.y));
        Thrown often = new Thrown(by(Integrator.RK4), 0, at -> at.accelerate(-4 * at.x, -4 * at.y));
        once.step(0.5, 0, 0);
        for (int i = 0; i < 4; i++) {
            often.step(0.125, 0, 0);
        }

        assertThat(once.bodies.x[0]).isEqualTo(often.bodies.x[0], within(1e-14));
        assertThat(once.bodies.velocityY[0]).isEqualTo(often.bodies.velocityY[0], within(1e-14));
    }

    /**
     * A drag of 400/s taken by a field, over ¼ s: one step of an explicit method would overshoot a
     * hundredfold. In substeps it comes to rest v/k further, within the thousandth that their h
     * leaves.
     */
    @ParameterizedTest
    @EnumSource(
            value = Integrator.class,
            names = {"RK4", "BALLISTIC"})
    void aStiffForceIsTakenInSubsteps(Integrator method) {
        Thrown thrown =
                new Thrown(
                        by(method),
                        0,
                        at -> at.accelerate(-400 * at.velocityX, -400 * at.velocityY));
        thrown.step(0.25, 0, 0);

        assertThat(thrown.bodies.x[0]).isEqualTo(1 + 3.0 / 400, within(3e-5));
        assertThat(thrown.bodies.y[0]).isEqualTo(2 + 4.0 / 400, within(4e-5));
        assertThat(Math.abs(thrown.bodies.velocityX[0])).isLessThan(1e-3);
        assertThat(Math.abs(thrown.bodies.velocityY[0])).isLessThan(1e-3);
    }

    /** 10⁷/s is too stiff for any substep: it brakes, and never throws back. */
    @Test
    void whatIsTooStiffBrakesWithoutOvershooting() {
        Thrown thrown =
                new Thrown(
                        by(Integrator.BALLISTIC),
                        0,
                        at -> at.accelerate(-1e7 * at.velocityX, -1e7 * at.velocityY));
        thrown.step(0.25, 0, 0);

        // One substep of 1/4096 s at most at the old speed, and none backwards.
        assertThat(thrown.bodies.x[0]).isBetween(1.0, 1 + 3.0 / 1024);
        assertThat(thrown.bodies.y[0]).isBetween(2.0, 2 + 4.0 / 1024);
        assertThat(Math.abs(thrown.bodies.velocityX[0])).isLessThan(1e-6);
        assertThat(Math.abs(thrown.bodies.velocityY[0])).isLessThan(1e-6);
    }

    /** Every one of many bodies has a path of its own, and sleepers and driven ones none. */
    @Test
    void everyAwakeDynamicBodyHasAPath() {
        Thrown thrown = new Thrown(by(Integrator.RK4), 0, 20, at -> at.accelerate(6 * at.time, 0));
        thrown.step(1, 0, 0);

        for (int slot = 0; slot < 20; slot++) {
            assertThat(thrown.bodies.x[slot]).isEqualTo(5, within(1e-13));
            assertThat(thrown.bodies.velocityX[slot]).isEqualTo(6, within(1e-13));
        }
    }

    /**
     * Where a path breaks off at ¼ of its length the cubic lacks σ(3σ − 2) of what its end lacks.
     */
    @Test
    void whatIsMetOnTheWayHasTheVelocityOfTheCubic() {
        Accuracy accuracy = by(Integrator.BALLISTIC);
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

        // v = 3 + 2·¼, and of the lack 3 − 2 = 1 the share ¼·(¾ − 2).
        assertThat(storage.bodies.velocityX[0]).isEqualTo(3.5 - 0.3125, within(1e-14));
        double then = storage.bodies.velocityX[0];
        course.catchUp(0, 0.5);
        assertThat(storage.bodies.velocityX[0]).as("only once").isEqualTo(then);
    }

    /** What a pull adds is told apart from what is steady: piles take only that. */
    @Test
    void tellsThePullFromWhatIsSteady() {
        Thrown thrown = new Thrown(by(Integrator.BALLISTIC), 2, at -> at.accelerate(5, 7));
        for (int i = 0; i < 2; i++) {
            thrown.bodies.accelerationX[0] = 1;
            thrown.bodies.accelerationY[0] = -8;
            thrown.course.begin(1e-3);
            // To first order in k·h = 2·10⁻³.
            assertThat(thrown.bodies.pullX[0]).isEqualTo(5, within(0.02));
            assertThat(thrown.bodies.pullY[0]).isEqualTo(7, within(0.02));
            assertThat(thrown.bodies.accelerationX[0])
                    .isEqualTo(1 + thrown.bodies.pullX[0], within(1e-12));
            assertThat(thrown.bodies.accelerationY[0])
                    .isEqualTo(-8 + thrown.bodies.pullY[0], within(1e-12));
        }
    }

    @Test
    void aForceWithoutANumberIsToldAtTheStart() {
        Thrown thrown = new Thrown(by(Integrator.BALLISTIC), 0, at -> at.accelerate(Double.NaN, 0));
        thrown.bodies.accelerationX[0] = 0;
        thrown.course.begin(0.5);

        assertThat(thrown.bodies.accelerationX[0]).isNaN();
    }

    @Test
    void aPathOfNoLengthChangesNothing() {
        Thrown thrown = new Thrown(by(Integrator.BALLISTIC), 0, at -> at.accelerate(5, 7));
        thrown.course.begin(1);
        double before = thrown.bodies.accelerationX[0];
        thrown.course.lay(0, 1, 1);

        assertThat(thrown.bodies.accelerationX[0]).isEqualTo(before);
    }
}
