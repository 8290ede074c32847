package rigibo.lab.problem;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;

import java.util.List;

/** The problems of crowds, each with few bodies. */
class CrowdProblemTest {

    private static List<Problem> crowds() {
        return List.of(CrowdProblem.rain(6), CrowdProblem.settling(3), CrowdProblem.struck(3));
    }

    private static Errors errors(Engine engine, Problem problem, String preset) {
        try (Bench bench = Bench.counting(engine, setting(engine, preset))) {
            return problem.set(bench).run();
        }
    }

    private static Setting setting(Engine engine, String preset) {
        return Engines.setting(engine, preset);
    }

    @ParameterizedTest
    @MethodSource("crowds")
    void fewBodiesHardlyOverlapAndGainNothing(Problem problem) {
        Errors errors = errors(new RigiBoEngine(), problem, "GAME");
        assertThat(errors.failure()).isEmpty();
        assertThat(errors.main()).as(problem.id()).isLessThan(problem.equalBelow());
        // Round-off of the sums of energy.
        assertThat(errors.others().get("energy gained / start")).isLessThan(1e-9);
    }

    /** Places that are 1 % nearer to each other overlap by 1 % of a width at the least. */
    @ParameterizedTest
    @MethodSource("crowds")
    void overlapIsSeen(Problem problem) {
        assertThat(errors(new Exaggerating(0.99), problem, "GAME").main()).isGreaterThan(0.01);
    }

    /** Places that are 1 % nearer to each other are off by 1 % of the arms, of 20 cm, or more. */
    @Test
    void jointsThatComeApartAreSeen() {
        Problem ragdoll = CrowdProblem.ragdolls(1);
        assertThat(errors(new RigiBoEngine(), ragdoll, "GAME").main()).isLessThan(1e-3);
        assertThat(errors(new Exaggerating(0.99), ragdoll, "GAME").main()).isGreaterThan(2e-3);
    }

    /** Half of what falls is soon motion, and 1 % more speed is 2 % more of it, height but 1 %. */
    @Test
    void energyThatNobodyPutInIsSeen() {
        Errors errors = errors(new Exaggerating(1.01), CrowdProblem.rain(6), "GAME");
        assertThat(errors.others().get("energy gained / start")).isBetween(1e-3, 1e-2);
    }

    /** Upside down everything is below the floor. */
    @ParameterizedTest
    @MethodSource("crowds")
    void lostBodiesFail(Problem problem) {
        Errors errors = errors(new Exaggerating(-1), problem, "GAME");
        assertThat(errors.failure()).contains("fell through the floor");
    }

    /** Three worlds: the first, in which Java compiles the engine, does not count. */
    @Test
    void stepsAreTimedWhileTheyAreLookedAt() {
        Engine engine = new RigiBoEngine();
        try (Bench bench = Bench.counting(engine, setting(engine, "DRAFT"))) {
            CrowdProblem.rain(6).set(bench).run();
            assertThat(bench.tally().steps()).isEqualTo(bench.steps() * 2 / 3);
            assertThat(bench.tally().cpuMicros()).isPositive();
        }
    }
}
