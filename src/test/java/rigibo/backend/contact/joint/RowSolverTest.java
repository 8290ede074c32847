package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;

/** Rows with bounds of a joint, on a body of 1 kg and 1 kg·m². */
class RowSolverTest {

    private static final int BODY = OneBody.BODY;

    private final Motions motions = OneBody.of(1);
    private final NeutralRows rows = new NeutralRows(motions, null);
    private final RowElimination elimination = new RowElimination(motions, rows);
    private final RowSolver solver = new RowSolver(motions, rows, elimination, Accuracy.GAME);

    @BeforeEach
    void beginIsland() {
        elimination.beginIsland(1e6);
    }

    private int turning(double target, double lower, double upper) {
        int row = rows.add();
        rows.derive(row, BODY, 0, 0, 1);
        rows.joint[row] = 0;
        rows.target[row] = target;
        rows.lower[row] = lower;
        rows.upper[row] = upper;
        rows.finish(row);
        return row;
    }

    /**
     * A body turns at w towards a limit that it may reach at −0.01 rad/s; a brake of up to b N·m·s
     * acts on the same hinge. The brake alone stops the body if it can. Otherwise it gives b, and
     * the limit gives the rest: w + b + limit = −0.01.
     */
    @ParameterizedTest
    @CsvSource({
        "-1, 2, -0, 1, 0",
        "-1, 0.5, -0.01, 0.5, 0.49",
        "-1, 0.995, -0.005, 0.995, 0",
        "-1, 0.98, -0.01, 0.98, 0.01",
        "1, 0.5, 0.5, -0.5, 0",
    })
    void aLimitAndABrakeOfOneHingeDoNotOpposeEachOther(
            double speed, double brake, double after, double braked, double limited) {
        motions.data[BODY + Motions.SPIN] = speed;
        int limit = turning(-0.01, 0, Double.POSITIVE_INFINITY);
        rows.holdsPlace[limit] = true;
        int motor = turning(0, -brake, brake);
        solver.begin();
        boolean isSolved = solver.solve(1e-9);
        assertThat(isSolved).isTrue();
        assertThat(motions.data[BODY + Motions.SPIN]).isCloseTo(after, within(1e-9));
        assertThat(rows.impulse[motor]).isCloseTo(braked, within(1e-9));
        assertThat(rows.impulse[limit]).isCloseTo(limited, within(1e-9));
    }

    /** Passes have diverged; an equation must then hold to the round-off of the bodies' motion. */
    @Test
    void whatRanAwayDoesNotTellWhatCountsAsSolved() {
        int equation = rows.add();
        rows.derive(equation, BODY, 1, 0, 0);
        rows.finish(equation);
        int limit = turning(0, 0, Double.POSITIVE_INFINITY);
        rows.impulse[limit] = 1e15;
        motions.data[BODY + Motions.VX] = 1;
        solver.begin();
        solver.solve(1e-9);
        rows.push(equation, 1 - motions.data[BODY + Motions.VX]);
        rows.impulse[limit] = 0;
        solver.holdEquations();
        assertThat(motions.data[BODY + Motions.VX]).isCloseTo(0, within(1e-12));
    }

    /**
     * A load with a lever of 0.5 m turns a body to ω = t/0.5, and friction with a lever of 1 m
     * holds it. The wedge locks itself, since friction can bear twice what the load turns, and only
     * round-off bounds its stress. Friction with a compliance g towards changes of its last impulse
     * c lets the body turn at ω = g·(f − c); then load · 0.5 = ω + f.
     */
    @ParameterizedTest
    @CsvSource({"1e-4, 1e-3, 0", "1e-2, 1e-3, 0", "1e-4, 0.1, 0", "1e-4, 1e-3, 0.5"})
    void frictionThatGivesWayFreesAWedgeOfStress(double target, double giving, double before) {
        int load = contact(0.5, target);
        int friction = contact(1, 0);
        rows.load[friction] = load;
        rows.loads[friction] = 1;
        rows.share[friction] = 1;
        rows.impulse[friction] = -before;
        motions.data[BODY + Motions.SPIN] = -before;
        solver.beginAsBefore(null, 1);
        solver.solve(1e-9);
        assertThat(Math.abs(rows.impulse[load])).isGreaterThan(1e4 * target);
        motions.data[BODY + Motions.SPIN] = 0;
        rows.impulse[load] = 0;
        rows.impulse[friction] = 0;
        solver.beginSoftened(null, 1, giving);
        boolean isSolved = solver.solve(1e-9);
        assertThat(isSolved).isTrue();
        double spin = target / 0.5;
        double carried = before + spin / giving;
        assertThat(motions.data[BODY + Motions.SPIN]).isCloseTo(spin, within(1e-8 * spin));
        assertThat(-rows.impulse[friction]).isCloseTo(carried, within(1e-6 * carried));
        assertThat(rows.impulse[load]).isCloseTo((spin + carried) / 0.5, within(1e-6 * carried));
    }

    /**
     * A body of 1 kg lies on the floor with a load of j = 2 N·s and μ = 0.5; the last kick left a
     * tiny gap. Friction of f in that kick at its bound, ±1 N·s, slid, and slides again. Friction
     * below it is placed by the speed, which it can stop here.
     */
    @ParameterizedTest
    @CsvSource({"-1, 3, false", "-0.9995, 3, false", "1, -3, false", "-0.4, 0.1, true"})
    void aContactBeginsAsItEnded(double carried, double speed, boolean sticks) {
        int load = along(0, 1);
        int friction = along(1, 0);
        rows.load[friction] = load;
        rows.loads[friction] = 1;
        rows.share[friction] = 0.5;
        rows.impulse[load] = 2;
        rows.impulse[friction] = carried;
        motions.data[BODY + Motions.VX] = speed;
        motions.data[BODY + Motions.VY] = 1e-12;
        solver.beginAsBefore(null, 1);
        assertThat(elimination.isIn(load)).isTrue();
        assertThat(elimination.isIn(friction)).isEqualTo(sticks);
        assertThat(solver.solve(1e-9)).isTrue();
        double left = sticks ? 0 : speed + Math.signum(carried) - carried;
        assertThat(motions.data[BODY + Motions.VX]).isCloseTo(left, within(1e-9));
        assertThat(motions.data[BODY + Motions.VY]).isCloseTo(0, within(1e-9));
        assertThat(rows.impulse[load]).isCloseTo(2, within(1e-9));
        assertThat(elimination.isIn(friction)).isEqualTo(sticks);
    }

    private int along(double x, double y) {
        int row = rows.add();
        rows.contact[row] = 0;
        rows.derive(row, BODY, x, y, 0);
        rows.lower[row] = 0;
        rows.finish(row);
        return row;
    }

    private int contact(double lever, double target) {
        int row = rows.add();
        rows.contact[row] = 0;
        rows.derive(row, BODY, 0, 0, lever);
        rows.target[row] = target;
        rows.lower[row] = 0;
        rows.finish(row);
        return row;
    }
}
