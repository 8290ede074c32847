package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.DistanceJoint;
import rigibo.backend.GearJoint;
import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.MotorJoint;
import rigibo.backend.MouseJoint;
import rigibo.backend.Pool;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.PulleyJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.WheelJoint;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.storage.DataStorage;

import java.util.SplittableRandom;

/**
 * Rows of joints of every kind, at random poses. The derivative of a row is that of its place: a
 * central difference by 10⁻⁶ has errors of 10⁻¹⁰ by round-off and 10⁻¹² by curvature.
 */
class JointRowsTest {

    private static final double STEP = 1e-6;
    private static final double DIFFERENCE = 2e-9;
    private static final double ROUND_OFF = 1e-12;
    private static final double KICK = 0.01;
    private static final double DRIFT = 0.02;

    private final JointedIsland island = new JointedIsland();
    private final Pool pool = island.pool;
    private final DataStorage data = island.data;
    private final RigidBody ground = island.ground;
    private final RigidBody a = island.a;
    private final RigidBody b = island.b;
    private final RigidBody c = island.c;
    private final Motions motions = island.motions;
    private final NeutralRows rows = island.rows;
    private final PackedJoints packed = island.packed;
    private final Poses poses = island.poses;
    private final RowStates states = island.states;
    private final JointRows jointRows = island.jointRows;

    private void write(int jointCount) {
        island.pack(jointCount, KICK);
    }

    private void writeRows() {
        poses.take(0);
        rows.clear();
        jointRows.write(KICK, DRIFT);
    }

    private void displace(SplittableRandom random) {
        for (int entry = 1; entry < motions.count; entry++) {
            for (int column = Motions.DX; column <= Motions.TURN; column++) {
                motions.data[entry * Motions.STRIDE + column] = random.nextDouble(-0.3, 0.3);
            }
        }
    }

    private double placeWith(int row, int at, double by) {
        double before = motions.data[at];
        motions.data[at] = before + by;
        poses.take(0);
        jointRows.places.measureAnew();
        double place = jointRows.places.of(row);
        motions.data[at] = before;
        return place;
    }

    /** The row's derivative by a column of the displacements. */
    private double derivative(int row, int at) {
        double[] velocities = motions.data.clone();
        for (int entry = 0; entry < motions.count; entry++) {
            motions.halt(entry * Motions.STRIDE);
        }
        motions.data[at - Motions.DX] = 1;
        double speed = rows.speed(row);
        System.arraycopy(velocities, 0, motions.data, 0, velocities.length);
        return speed;
    }

    private void assertDerivatives(int row) {
        for (int entry = 1; entry < motions.count; entry++) {
            for (int column = Motions.DX; column <= Motions.TURN; column++) {
                int at = entry * Motions.STRIDE + column;
                double difference = placeWith(row, at, STEP) - placeWith(row, at, -STEP);
                assertThat(derivative(row, at))
                        .as("row %d of part %d", row, rows.part[row])
                        .isCloseTo(difference / (2 * STEP), within(DIFFERENCE));
            }
        }
    }

    /** All rows that hold a place; fails unless there are {@code places} of them. */
    private void assertAllFollowTheirPlaces(JointDefinition definition, int places) {
        pool.join(definition);
        write(1);
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 10; i++) {
            writeRows();
            int held = 0;
            for (int row = 0; row < rows.count; row++) {
                if (rows.holdsPlace[row]) {
                    held++;
                    jointRows.places.measureAnew();
                    poses.take(0);
                    assertThat(rows.place[row])
                            .isCloseTo(jointRows.places.of(row), within(ROUND_OFF));
                    assertDerivatives(row);
                }
            }
            assertThat(held).isEqualTo(places);
            displace(random);
        }
    }

    private enum Kind {
        REVOLUTE,
        PRISMATIC,
        WHEEL,
        WELD,
        ROD,
        ROPE,
        PULLEY
    }

    private JointDefinition of(Kind kind, RigidBody first, RigidBody second) {
        return switch (kind) {
            case REVOLUTE -> RevoluteJoint.at(first, second, 0.9, 0.1).limits(-1, 2);
            case PRISMATIC -> PrismaticJoint.along(first, second, 0.9, 0.1, 0.7).limits(-0.5, 0.4);
            case WHEEL -> WheelJoint.at(first, second, 0.9, 0.1, 0.7).limits(-0.5, 0.4);
            case WELD -> WeldJoint.at(first, second, 0.9, 0.1);
            case ROD -> DistanceJoint.rod(first, 0.5, 0.3, second, 1.6, -0.1);
            case ROPE -> DistanceJoint.rod(first, 0.5, 0.3, second, 1.6, -0.1).limits(0.2, 3);
            case PULLEY -> PulleyJoint.over(first, second, 5);
        };
    }

    /** Equations, and a row for each limit. */
    private static int places(Kind kind) {
        return switch (kind) {
            case REVOLUTE, PRISMATIC -> 4;
            case WHEEL, WELD -> 3;
            case ROPE -> 2;
            case ROD, PULLEY -> 1;
        };
    }

    @ParameterizedTest
    @EnumSource(Kind.class)
    void derivativesAreThoseOfTheirPlaces(Kind kind) {
        assertAllFollowTheirPlaces(of(kind, a, b), places(kind));
    }

    @ParameterizedTest
    @EnumSource(Kind.class)
    void groundHasNoDerivative(Kind kind) {
        assertAllFollowTheirPlaces(of(kind, ground, b), places(kind));
        for (int row = 0; row < rows.count; row++) {
            assertThat(rows.bodies[row]).isEqualTo(1);
        }
    }

    /** At the start no place is off, and limits are as far away as stated. */
    @ParameterizedTest
    @EnumSource(Kind.class)
    void jointsBeginWithoutError(Kind kind) {
        pool.join(of(kind, a, b));
        write(1);
        writeRows();
        for (int row = 0; row < rows.count; row++) {
            if (rows.isEquation(row)) {
                assertThat(rows.place[row]).isCloseTo(0, within(ROUND_OFF));
            }
        }
        if (kind == Kind.REVOLUTE) {
            assertThat(rows.place[2]).isCloseTo(1, within(ROUND_OFF));
            assertThat(rows.place[3]).isCloseTo(2, within(ROUND_OFF));
            // A gap may close by the end of the drift; the stop only pushes.
            assertThat(rows.target[2]).isCloseTo(-1 / DRIFT, within(1e-9));
            assertThat(rows.target[3]).isCloseTo(-2 / DRIFT, within(1e-9));
            assertThat(rows.lower[3]).isZero();
            assertThat(rows.upper[3]).isEqualTo(Double.POSITIVE_INFINITY);
        }
    }

    /** q₁ + ratio·q₂ of hinges and sliders with a common base. */
    @ParameterizedTest
    @EnumSource(
            value = Kind.class,
            names = {"REVOLUTE", "PRISMATIC"})
    void gearsCoupleBothCoordinates(Kind second) {
        Joint first = pool.join(RevoluteJoint.at(a, b, 0.9, 0.1));
        Joint other =
                pool.join(
                        second == Kind.REVOLUTE
                                ? RevoluteJoint.at(a, c, 1, 0.6)
                                : PrismaticJoint.along(a, c, 1, 0.6, 0.4));
        pool.join(GearJoint.of(first, other, -2.5));
        write(3);
        displace(new SplittableRandom(2));
        writeRows();
        int gear = rows.count - 1;
        assertThat(rows.joint[gear]).isEqualTo(2);
        assertThat(rows.holdsPlace[gear]).isTrue();
        assertDerivatives(gear);
        poses.take(0);
        jointRows.places.measureAnew();
        assertThat(rows.place[gear]).isCloseTo(jointRows.places.of(gear), within(ROUND_OFF));
    }

    /** A wheel's motor turns it, those of others drive their coordinate; all within ± F·h. */
    @Test
    void motorsAimAtTheirSpeed() {
        pool.join(RevoluteJoint.at(a, b, 0.9, 0.1).motor(3, 50));
        pool.join(PrismaticJoint.along(a, c, 0.9, 0.1, 0.7).motor(-2, 70));
        pool.join(WheelJoint.at(b, c, 0.9, 0.1, 0.7).motor(5, 90));
        write(3);
        displace(new SplittableRandom(3));
        writeRows();
        double[] speeds = {3, -2, 5};
        double[] most = {50, 70, 90};
        JointGeometry geometry = new JointGeometry(data.bodies, data.joints, poses);
        int motors = 0;
        for (int row = 0; row < rows.count; row++) {
            if (rows.part[row] != JointRows.MOTOR) {
                continue;
            }
            int joint = rows.joint[row];
            motors++;
            assertThat(rows.target[row]).isEqualTo(speeds[joint]);
            assertThat(rows.upper[row]).isCloseTo(most[joint] * KICK, within(ROUND_OFF));
            assertThat(rows.lower[row]).isEqualTo(-rows.upper[row]);
            assertThat(rows.holdsPlace[row]).isFalse();
            for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at++) {
                int column = at % Motions.STRIDE;
                if (column >= Motions.DX && column <= Motions.TURN) {
                    double change = driven(geometry, joint, at, STEP);
                    change -= driven(geometry, joint, at, -STEP);
                    assertThat(derivative(row, at))
                            .isCloseTo(change / (2 * STEP), within(DIFFERENCE));
                }
            }
        }
        assertThat(motors).isEqualTo(3);
    }

    private double driven(JointGeometry geometry, int joint, int at, double by) {
        double before = motions.data[at];
        motions.data[at] = before + by;
        poses.take(0);
        geometry.measure(joint, packed.offsetA[joint], packed.offsetB[joint]);
        motions.data[at] = before;
        return joint == 1 ? geometry.along : geometry.angle;
    }

    /** Friction between two bodies: a disc of forces, and a torque by itself. */
    @Test
    void motorJointHoldsWithinADisc() {
        pool.join(MotorJoint.friction(a, b, 50, 70));
        write(1);
        writeRows();
        assertThat(rows.count).isEqualTo(3);
        assertThat(rows.twin[0]).isEqualTo(1);
        assertThat(rows.twin[1]).isZero();
        assertThat(rows.share[0]).isCloseTo(50 * KICK, within(ROUND_OFF));
        assertThat(rows.share[1]).isCloseTo(50 * KICK, within(ROUND_OFF));
        assertThat(rows.upper[2]).isCloseTo(70 * KICK, within(ROUND_OFF));
        for (int row = 0; row < 3; row++) {
            assertThat(rows.target[row]).isZero();
        }
        // Bounded forces have no effect in an impact.
        rows.clear();
        jointRows.writeAtOnce();
        assertThat(rows.count).isZero();
    }

    /** The hand pulls at an anchor of B alone: derivatives of the anchor's place. */
    @Test
    void mousePullsAtItsAnchor() {
        pool.join(MouseJoint.of(ground, b, 1.6, -0.1));
        write(1);
        displace(new SplittableRandom(4));
        writeRows();
        assertThat(rows.count).isEqualTo(2);
        JointGeometry geometry = new JointGeometry(data.bodies, data.joints, poses);
        int offset = packed.offsetB[0];
        for (int column = Motions.DX; column <= Motions.TURN; column++) {
            double[] x = new double[2];
            double[] y = new double[2];
            for (int side = 0; side < 2; side++) {
                double before = motions.data[offset + column];
                motions.data[offset + column] += side == 0 ? -STEP : STEP;
                poses.take(0);
                geometry.measure(0, packed.offsetA[0], offset);
                x[side] = geometry.fromTargetX(0, offset);
                y[side] = geometry.fromTargetY(0, offset);
                motions.data[offset + column] = before;
            }
            assertThat(derivative(0, offset + column))
                    .isCloseTo((x[1] - x[0]) / (2 * STEP), within(DIFFERENCE));
            assertThat(derivative(1, offset + column))
                    .isCloseTo((y[1] - y[0]) / (2 * STEP), within(DIFFERENCE));
        }
        // Its compliance is that of a damped spring solved at the end of the drift.
        double k = data.joints.stiffness[0];
        double damping = data.joints.damping[0];
        double give = 1 / (KICK * (damping + DRIFT * k));
        assertThat(rows.give[0]).isCloseTo(give, within(1e-9 * give));
    }

    /** Equal limits are one equation, in an impact as well. */
    @Test
    void equalLimitsAreAnEquation() {
        pool.join(RevoluteJoint.at(a, b, 0.9, 0.1).limits(0.3, 0.3));
        write(1);
        writeRows();
        assertThat(rows.count).isEqualTo(3);
        assertThat(rows.isEquation(2)).isTrue();
        assertThat(rows.place[2]).isCloseTo(-0.3, within(ROUND_OFF));
    }

    /** An open stop cannot push; a held one is an equation. */
    @Test
    void stopsMayBeOpenOrHeld() {
        pool.join(RevoluteJoint.at(a, b, 0.9, 0.1).limits(-1, 2, 0.25));
        write(1);
        states.setJoint(0, JointRows.LOWER, RowStates.OPEN);
        states.setJoint(0, JointRows.UPPER, RowStates.HELD);
        writeRows();
        assertThat(rows.upper[2]).isZero();
        assertThat(rows.lower[2]).isZero();
        assertThat(rows.isEquation(3)).isTrue();
        assertThat(rows.elasticity[2]).isEqualTo(0.25);
        assertThat(rows.elasticity[3]).isEqualTo(0.25);
    }

    /** J·M⁻¹·Jᵀ by the velocities that a unit impulse gives. */
    @ParameterizedTest
    @EnumSource(Kind.class)
    void responsesAreSpeedsByUnitImpulses(Kind kind) {
        pool.join(of(kind, a, b));
        write(1);
        writeRows();
        for (int row = 0; row < rows.count; row++) {
            double before = rows.speed(row);
            rows.push(row, 2);
            assertThat(rows.speed(row) - before).isCloseTo(2 * rows.response[row], within(1e-9));
            assertThat(rows.impulse[row]).isEqualTo(2);
            double expected = rows.speed(row) + 0.5 * 2 - rows.target[row];
            rows.give[row] = 0.5;
            assertThat(rows.residual(row)).isCloseTo(expected, within(1e-9));
        }
    }
}
