package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;
import java.util.SplittableRandom;

/** Skipped rows against the residuals that they would have had. */
class RowMarginsTest {

    private static final int LOOSE = 6;
    private static final int JOINED = 5;

    private final Motions motions = new Motions(true);
    private final NeutralRows rows = new NeutralRows(motions, null);
    private final EquationFactor factor = new EquationFactor(motions, rows);
    private final GroupVelocities velocities = new GroupVelocities(null, motions, rows, factor);
    private final Responses responses = new Responses(motions, rows, factor, velocities);
    private final RowMargins margins = new RowMargins(rows, velocities);

    /** Free bodies and then a chain of hinges, all of mass 1 kg and inertia 1 kg·m². */
    @BeforeEach
    void addBodies() {
        int count = LOOSE + JOINED;
        motions.data = new double[(count + 1) * Motions.STRIDE];
        motions.slots = new int[count + 1];
        motions.reach = new double[count + 1];
        motions.count = count + 1;
        Arrays.fill(motions.reach, 0.5);
        for (int body = 1; body <= count; body++) {
            motions.data[body * Motions.STRIDE + Motions.INVERSE_MASS] = 1;
            motions.data[body * Motions.STRIDE + Motions.INVERSE_INERTIA] = 1;
        }
        for (int body = LOOSE + 1; body < count; body++) {
            for (int axis = 0; axis < 2; axis++) {
                int row = rows.add();
                rows.derive(row, body * Motions.STRIDE, axis - 1, -axis, 0.5 * axis);
                rows.derive(row, (body + 1) * Motions.STRIDE, 1 - axis, axis, 0.5 * axis);
                rows.finish(row);
            }
        }
    }

    private void begin() {
        factor.layOut();
        factor.changeAll();
        responses.begin();
        margins.list();
        margins.begin();
    }

    /** A row that only pushes a body up, or turns it as well, by an arm in m. */
    private int push(int body, double arm) {
        int row = rows.add();
        rows.lower[row] = 0;
        rows.derive(row, body * Motions.STRIDE, 0, 1, arm);
        rows.finish(row);
        return row;
    }

    private void give(int row, double impulse) {
        responses.own(row);
        responses.push(row, impulse);
    }

    @Test
    void aRowIsIdleUntilItsBodyHasChangedByItsMargin() {
        int leaving = push(1, 0);
        int same = push(1, 0);
        int strange = push(2, 0);
        begin();
        assertThat(margins.isIdle(leaving)).isFalse();
        margins.note(leaving, 3);
        give(strange, 100);
        give(same, -2);
        assertThat(margins.isIdle(leaving)).isTrue();
        give(same, -1);
        assertThat(margins.isIdle(leaving)).isFalse();
    }

    /** With an arm of 2 m, a row's speed changes by twice the spin; with 0.5 m by half of it. */
    @Test
    void whatTurnsBringsLongArmsBackSooner() {
        int leaving = push(1, 2);
        int turning = rows.add();
        rows.lower[turning] = 0;
        rows.derive(turning, Motions.STRIDE, 0, 0, 1);
        rows.finish(turning);
        begin();
        assertThat(margins.steepest(leaving)).isEqualTo(1 + 2 / 0.5);
        margins.note(leaving, 5);
        give(turning, 1.9);
        assertThat(margins.isIdle(leaving)).isTrue();
        give(turning, 0.2);
        assertThat(margins.isIdle(leaving)).isFalse();
    }

    @Test
    void onlyRowsAtABoundThatTheyLeaveAreIdle() {
        int row = push(1, 0);
        begin();
        margins.note(row, -1);
        assertThat(margins.isIdle(row)).isFalse();
        rows.impulse[row] = 1;
        margins.note(row, 1);
        assertThat(margins.isIdle(row)).isFalse();
        rows.upper[row] = 1;
        margins.note(row, -1);
        assertThat(margins.isIdle(row)).isTrue();
        margins.forget(row);
        assertThat(margins.isIdle(row)).isFalse();
    }

    @Test
    void rowsOfThreeBodiesAreAlwaysAsked() {
        int row = push(1, 0);
        rows.derive(row, 2 * Motions.STRIDE, 0, 1, 0);
        rows.derive(row, 3 * Motions.STRIDE, 0, 1, 0);
        rows.finish(row);
        begin();
        margins.note(row, 1);
        assertThat(margins.isIdle(row)).isFalse();
    }

    /** A row that may be skipped keeps moving away from its bound, whatever is pushed. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void idleRowsWouldCarryNothing(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int first = rows.count;
        for (int i = 0; i < 60; i++) {
            int row = rows.add();
            int a = random.nextInt(0, motions.count);
            int b = random.nextInt(1, motions.count);
            rows.lower[row] = 0;
            rows.target[row] = -random.nextDouble(0, 8);
            derive(row, a == b ? 0 : a, random);
            derive(row, b, random);
            rows.finish(row);
        }
        begin();
        int idle = 0;
        int back = 0;
        for (int push = 0; push < 1000; push++) {
            for (int row = first; row < rows.count; row++) {
                if (margins.isIdle(row)) {
                    idle++;
                    assertThat(velocities.residual(row)).isPositive();
                } else {
                    margins.note(row, velocities.residual(row));
                    back += velocities.residual(row) < 0 ? 1 : 0;
                }
            }
            give(random.nextInt(first, rows.count), random.nextDouble(-0.3, 0.3));
        }
        assertThat(idle).isGreaterThan(2_000);
        assertThat(back).isGreaterThan(100);
    }

    private void derive(int row, int body, SplittableRandom random) {
        rows.derive(
                row,
                body * Motions.STRIDE,
                random.nextDouble(-1, 1),
                random.nextDouble(-1, 1),
                random.nextDouble(-1, 1));
    }
}
