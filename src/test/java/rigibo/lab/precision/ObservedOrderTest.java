package rigibo.lab.precision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.lab.engine.Line;
import rigibo.lab.precision.ObservedOrder.Verdict;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.DoubleUnaryOperator;

class ObservedOrderTest {

    private static List<Point> line(DoubleUnaryOperator error) {
        List<Point> points = new ArrayList<>();
        for (int parts = 1; parts <= 32; parts *= 2) {
            double step = 1.0 / (30 * parts);
            double reached = error.applyAsDouble(step);
            points.add(FakePoints.point("step", Line.STEP_RK4, step, step, reached, 1e-3 * parts));
        }
        Collections.shuffle(points, new java.util.Random(3));
        return points;
    }

    private static Verdict verdict(Line line, DoubleUnaryOperator error) {
        List<Point> points = line(error);
        return ObservedOrder.of(points).verdict(line, points);
    }

    @ParameterizedTest
    @CsvSource({"1, STEP_EULER", "2, STEP_VERLET", "4, STEP_RK4"})
    void powerOfTheStepIsObserved(int power, Line line) {
        List<Point> points = line(step -> 0.1 * Math.pow(step, power));
        ObservedOrder order = ObservedOrder.of(points);
        assertThat(order.median()).isCloseTo(power, within(1e-9));
        assertThat(order.verdict(line, points)).isEqualTo(Verdict.AS_EXPECTED);
    }

    /** At 1/240 s the error of a fourth power is 3e-13 and less: of rounding. */
    @Test
    void errorsOfRoundingTellNoOrder() {
        ObservedOrder order = ObservedOrder.of(line(step -> 1e-3 * Math.pow(step, 4) + 1e-16));
        assertThat(order.pairs()).isLessThan(5);
        assertThat(order.median()).isCloseTo(4, within(0.01));
        assertThat(verdict(Line.STEP_VERLET, step -> 1e-16)).isEqualTo(Verdict.EXACT);
    }

    @Test
    void whatDiffersFromTheMethodIsSaid() {
        assertThat(verdict(Line.STEP_VERLET, step -> step)).isEqualTo(Verdict.LOWER);
        assertThat(verdict(Line.STEP_EULER, step -> step * step)).isEqualTo(Verdict.HIGHER);
        assertThat(verdict(Line.STEP, step -> 1e-5)).isEqualTo(Verdict.FLAT);
        assertThat(verdict(Line.STEP, step -> 1e-5 / step)).isEqualTo(Verdict.RISING);
        assertThat(verdict(Line.STEP, step -> step * step)).isEqualTo(Verdict.SOME);
    }
}
