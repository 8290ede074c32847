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

import java.util.concurrent.atomic.AtomicInteger;

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

    @ParameterizedTest
    @EnumSource(
            value = Integrator.class,
            names = {"EULER", "VERLET", "RK4"})
    void substepsAreStepsOfAPath(Integrator method) {
        Accuracy four = by(method).withSubsteps(4);
        Thrown once = new Thrown(four, 0, at -> at.accelerate(-4 * at.x, -4 * at.y));
        Thrown often = new Thrown(by(method), 0, at -> at.accelerate(-4 * at.x, -4 * at.y));
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

        // The first substep undoes all of the velocity, and no more.
        assertThat(thrown.bodies.x[0]).isEqualTo(1, within(1e-9));
        assertThat(thrown.bodies.y[0]).isEqualTo(2, within(1e-9));
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(0, within(1e-6));
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(0, within(1e-6));
    }

    /**
     * With kh = 3 the simple methods take their step all the same. Euler: v(1 − kh), and on with
     * that; Verlet: on with v − kvh/2, and the mean of −kv and −k(v − kvh).
     */
    @ParameterizedTest
    @CsvSource({"EULER, -2, -2", "VERLET, 2.5, -0.5"})
    void theSimpleMethodsTakeTheStepTheyAreTold(Integrator method, double speed, double way) {
        Thrown thrown =
                new Thrown(
                        by(method), 0, at -> at.accelerate(-6 * at.velocityX, -6 * at.velocityY));
        thrown.step(0.5, 0, 0);

        assertThat(thrown.bodies.x[0]).isEqualTo(1 + 3 * way * 0.5, within(1e-13));
        assertThat(thrown.bodies.y[0]).isEqualTo(2 + 4 * way * 0.5, within(1e-13));
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(3 * speed, within(1e-13));
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(4 * speed, within(1e-13));
    }

    /** In a spring of 4/s² Euler takes the pull at the start, Verlet the mean of both ends. */
    @ParameterizedTest
    @CsvSource({"EULER, 1, 0", "VERLET, 0.5, 0.5"})
    void theSimpleMethodsTakeTheMeanOfTheirPulls(Integrator method, double atStart, double atEnd) {
        Thrown thrown = new Thrown(by(method), 0, at -> at.accelerate(-4 * at.x, -4 * at.y));
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

    /** A drag of 19/s near its balance is as stiff as it is far from it. */
    @Test
    void nearItsBalanceADragIsAsStiff() {
        int looks =
                looks(
                        by(Integrator.RK4),
                        at ->
                                at.accelerate(
                                        -19 * (at.velocityX - 2.999),
                                        -19 * (at.velocityY - 3.999)));
        assertThat(looks).isEqualTo(2 + 3 * 10 + 9);
    }

    /** How often the field is asked in a step of ½ s from (1, 2) at (3, 4) m/s. */
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
     * The start and a thousandth ahead, to see how stiff it is; then for each of n substeps three
     * looks more, and for each but the first one where it starts. A drag with k·T = 9.5 takes ten.
     */
    @ParameterizedTest
    @CsvSource({"1.9, 1, 1", "19, 1, 10", "19, 16, 16", "0, 3, 3"})
    void dragTakesAsManySubstepsAsItIsStiff(double k, int told, int substeps) {
        Accuracy accuracy = by(Integrator.RK4).withSubsteps(told);
        int looks = looks(accuracy, at -> at.accelerate(-k * at.velocityX, -k * at.velocityY));

        assertThat(looks).isEqualTo(2 + 3 * substeps + (substeps - 1));
    }

    /**
     * A spring of ω that starts where its pull does not change to first order, with ωT = 3: the
     * looks at the middle differ by (ωh/2)², more than a quarter for one substep and for two. What
     * began is begun anew with four.
     */
    @Test
    void aSpringTakesTwiceAsManyUntilTheMiddlesAgree() {
        int looks =
                looks(
                        by(Integrator.RK4),
                        at ->
                                at.accelerate(
                                        -36 * (at.x - 1 - 3 * at.time - 1),
                                        -36 * (at.y - 2 - 4 * at.time - 1)));

        assertThat(looks).isEqualTo(2 + 3 + 1 + 3 + 1 + 4 * 3 + 3);
    }

    /**
     * x = t³, whose path is the cubic itself, broken off at ¼ and laid anew: the velocity at the
     * end is as if nothing had been. The place keeps what the laid parabola is off by at ¼, σ²(1 −
     * σ).
     */
    @ParameterizedTest
    @CsvSource({"1, 0", "0, 1", "-2, 1"})
    void aPathLaidAnewOnTheWayGoesOnAsItWas(double x, double y) {
        for (Integrator method : new Integrator[] {Integrator.RK4, Integrator.BALLISTIC}) {
            Thrown thrown =
                    new Thrown(
                            by(method), 0, at -> at.accelerate(6 * x * at.time, 6 * y * at.time));
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

            // The integral of 6t from 2 to 3 s is 15, and that of its integral 3t² − 12 is 7.
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

    /** Up to ten times the speed of light at the end, and as far as that leads in 2 s. */
    @ParameterizedTest
    @CsvSource({"1.4e9, true", "1.6e9, false"})
    void whatIsBoundedIsLaid(double acceleration, boolean isBounded) {
        Thrown thrown = new Thrown(by(Integrator.RK4), 0, at -> at.accelerate(acceleration, 0));
        thrown.bodies.accelerationX[0] = 0;
        thrown.course.begin(2);

        assertThat(Double.isNaN(thrown.bodies.accelerationX[0])).isNotEqualTo(isBounded);
    }

    @Test
    void aStepOfNoLengthChangesNothing() {
        Thrown thrown = new Thrown(by(Integrator.BALLISTIC), 0, at -> at.accelerate(5, 7));
        thrown.step(0, 0.5, -8);

        assertThat(thrown.bodies.x[0]).isEqualTo(1);
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(3);
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(4);
        assertThat(thrown.bodies.accelerationX[0]).isEqualTo(0.5);
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
        thrown.course.catchUp(0, 1);

        assertThat(thrown.bodies.accelerationX[0]).isEqualTo(before);
        assertThat(thrown.bodies.velocityX[0]).isEqualTo(3);
        assertThat(thrown.bodies.velocityY[0]).isEqualTo(4);
    }
}
