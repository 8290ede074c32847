package rigibo.lab.problem;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.Work;
import rigibo.lab.engine.World;

import java.util.List;

/** A run in which something is wrong does not pass for a right one. */
class TamperedTest {

    /** Our engine, but every velocity and place to the side or up is a little too large. */
    private record Exaggerating(double factor) implements Engine {

        @Override
        public String name() {
            return "exaggerating";
        }

        @Override
        public List<Setting> settings() {
            return new RigiBoEngine().settings();
        }

        @Override
        public World world(Effects effects, Setting setting) {
            return new Exaggerated(new RigiBoEngine().world(effects, setting), factor);
        }
    }

    private record Exaggerated(World world, double factor) implements World {

        @Override
        public int add(BodyDefinition body) {
            return world.add(body);
        }

        @Override
        public void remove(int body) {
            world.remove(body);
        }

        @Override
        public void step(double seconds) {
            world.step(seconds);
        }

        @Override
        public void push(int body, double forceX, double forceY) {
            world.push(body, forceX, forceY);
        }

        @Override
        public void drive(int body, double velocityX, double velocityY, double spin) {
            world.drive(body, factor * velocityX, factor * velocityY, spin);
        }

        @Override
        public double x(int body) {
            return factor * world.x(body);
        }

        @Override
        public double y(int body) {
            return factor * world.y(body);
        }

        @Override
        public double angle(int body) {
            return world.angle(body);
        }

        @Override
        public double velocityX(int body) {
            return factor * world.velocityX(body);
        }

        @Override
        public double velocityY(int body) {
            return factor * world.velocityY(body);
        }

        @Override
        public double spin(int body) {
            return world.spin(body);
        }

        @Override
        public void watchImpulses() {
            world.watchImpulses();
        }

        @Override
        public double normalImpulse(int a, int b) {
            return factor * world.normalImpulse(a, b);
        }

        @Override
        public Work lastStep() {
            return world.lastStep();
        }

        @Override
        public void close() {
            world.close();
        }
    }

    /** The least is some error in proportion to one in a hundred; R7 squares its. */
    @ParameterizedTest
    @CsvSource({
        "R1, 1e-3",
        "R2, 1e-3",
        "R4, 1e-3",
        "R5, 1e-3",
        "R6, 1e-3",
        "R7, 1e-5",
        "R8, 1e-3",
        "R9, 1e-3",
        "R10, 1e-3",
        "R13, 1e-3"
    })
    void onePerCentTooMuchIsAnError(String id, double least) {
        assertThat(errors(id, 1.01).main()).isGreaterThan(least);
        assertThat(errors(id, 1).main()).isLessThan(least);
    }

    /** What presses bodies into each other is seen as overlap. */
    @ParameterizedTest
    @CsvSource({"R11, 4e-3", "R12, 2"})
    void onePerCentTooLittleIsAnOverlap(String id, double least) {
        assertThat(errors(id, 0.99).main()).isGreaterThan(least);
        assertThat(errors(id, 1).main()).isLessThan(least);
    }

    private static Errors errors(String id, double factor) {
        Problem problem =
                Problems.all().stream()
                        .filter(one -> one.id().equals(id))
                        .findFirst()
                        .orElseThrow();
        Engine engine = new Exaggerating(factor);
        Setting exact = engine.settings().get(3);
        try (Bench bench = Bench.counting(engine, exact)) {
            return problem.set(bench).run();
        }
    }
}
