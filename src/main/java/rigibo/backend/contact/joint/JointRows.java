package rigibo.backend.contact.joint;

import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointStore;

/**
 * Writes the rows of joints. With p the anchors, n a direction and r the arms, a row that keeps
 * n·(p_b − p_a) has the derivatives n and r_b × n for B, and −n and −r_a × n for A; if n turns with
 * A, the vector between the anchors is added to A's arm (Catto, Modeling and solving constraints,
 * GDC 2009).
 */
final class JointRows {

    /** The rows that a joint can have. */
    static final int X = 0;

    static final int Y = 1;
    static final int ANGLE = 2;
    static final int LOWER = 3;
    static final int UPPER = 4;
    static final int MOTOR = 5;
    static final int SPRING = 6;

    private static final JointKind[] KINDS = JointKind.values();

    private final JointStore joints;
    private final NeutralRows rows;
    private final PackedJoints packed;
    private final RowStates states;
    private final JointGeometry geometry;
    private final JointGeometry other;
    private final SpringRows springs;
    private final BentSprings bent;

    /** The places of the rows that were written. */
    final JointPlaces places;

    /** How the rows hold their places in an island as long as its span. */
    final TautPlaces taut;

    /** What draws bodies back to the line of rods and ropes. */
    private final TautLines lines;

    /** The joint whose rows are being written: its number in the island, its slot, its offsets. */
    private int joint;

    private int slot;
    private int a;
    private int b;

    /** Length of the kick that is solved for, and of the drift after it, s. */
    private double kick;

    private double drift;

    /** Whether rows are written for an impact, in which bounded forces have no effect. */
    private boolean isAtOnce;

    JointRows(
            DataStorage data,
            NeutralRows rows,
            PackedJoints packed,
            Poses poses,
            RowStates states,
            TautLines lines) {
        joints = data.jointsOrNone();
        this.rows = rows;
        this.lines = lines;
        this.packed = packed;
        this.states = states;
        geometry = new JointGeometry(data.bodies, joints, poses);
        other = new JointGeometry(data.bodies, joints, poses);
        springs = new SpringRows(joints, rows);
        bent = new BentSprings(joints, rows, packed, poses, geometry);
        places = new JointPlaces(data, rows, packed, poses);
        taut = new TautPlaces(rows);
    }

    /**
     * Writes the rows of all joints at the poses taken, for a kick of a length in s that is
     * followed by a drift.
     */
    void write(double kickLength, double driftLength) {
        isAtOnce = false;
        writeAll(kickLength, driftLength, false);
    }

    /**
     * Writes the rows likewise; if {@code isLast}, nothing drifts after the kick, which is the last
     * of a substep with such a drift.
     *
     * @param share length of the kick as a share of that of the last one
     */
    void write(double kickLength, double driftLength, boolean isLast, double share) {
        isAtOnce = false;
        writeAll(kickLength, driftLength, isLast);
        if (!isLast) {
            bent.bend(driftLength, share);
        }
    }

    /** Writes the rows of all joints for an impact, without springs and motors of limited force. */
    void writeAtOnce() {
        isAtOnce = true;
        writeAll(1, 1, false);
    }

    private void writeAll(double kickLength, double driftLength, boolean isLast) {
        places.measureAnew();
        kick = kickLength;
        drift = driftLength;
        springs.begin(kickLength, driftLength, isLast);
        bent.begin();
        for (joint = 0; joint < packed.count; joint++) {
            slot = packed.slot[joint];
            a = packed.offsetA[joint];
            b = packed.offsetB[joint];
            geometry.measure(slot, a, b);
            writeJoint(KINDS[joints.kind[slot]]);
        }
    }

    private void writeJoint(JointKind kind) {
        switch (kind) {
            case REVOLUTE -> {
                point(X, 1, 0, geometry.dx);
                point(Y, 0, 1, geometry.dy);
                coordinate();
            }
            case PRISMATIC -> {
                axis(X, -geometry.axisY, geometry.axisX, geometry.across());
                angle(ANGLE, geometry.angle);
                coordinate();
            }
            case WHEEL -> {
                axis(X, -geometry.axisY, geometry.axisX, geometry.across());
                coordinate();
            }
            case WELD -> {
                point(X, 1, 0, geometry.dx);
                point(Y, 0, 1, geometry.dy);
                if (!(joints.stiffness[slot] > 0)) {
                    angle(ANGLE, geometry.angle);
                } else if (!isAtOnce) {
                    angle(SPRING, 0);
                    springs.write(slot, geometry.angle);
                    endSoft();
                }
            }
            case DISTANCE -> {
                distance();
                across();
            }
            case MOTOR -> motor();
            case MOUSE -> mouse();
            case GEAR -> gear();
            case PULLEY -> pulley();
            case FILTER -> throw new AssertionError("a filter has no rows");
        }
    }

    /** Begins a row of the joint. */
    private int row(int part) {
        int row = rows.add();
        rows.joint[row] = joint;
        rows.part[row] = part;
        return row;
    }

    /** Ends a row; one that can move nothing is dropped. */
    private int end(int row) {
        rows.finish(row);
        if (!(rows.response[row] > 0)) {
            rows.count--;
        }
        return row;
    }

    private int equation(int row, double place) {
        rows.place[row] = place;
        rows.holdsPlace[row] = true;
        end(row);
        if (areTaut() && row < rows.count) {
            taut.giveWay(row, place, places.lengthOf(row), kick, drift);
        }
        return row;
    }

    private boolean areTaut() {
        return taut.areTaut() && !isAtOnce;
    }

    /** n·(p_b − p_a) along an axis of the world. */
    private void point(int part, double nx, double ny, double place) {
        equation(apart(part, nx, ny), place);
    }

    private int apart(int part, double nx, double ny) {
        int row = row(part);
        rows.derive(row, a, -nx, -ny, -(geometry.armAX * ny - geometry.armAY * nx));
        rows.derive(row, b, nx, ny, geometry.armBX * ny - geometry.armBY * nx);
        return row;
    }

    /** n·(p_b − p_a) along a direction that turns with A or with the anchors. */
    private void axis(int part, double nx, double ny, double place) {
        int row = row(part);
        deriveAlong(row, geometry, a, b, nx, ny, 1);
        equation(row, place);
    }

    private void deriveAlong(
            int row, JointGeometry g, int onA, int onB, double nx, double ny, double factor) {
        double armX = g.armAX + g.dx;
        double armY = g.armAY + g.dy;
        rows.derive(row, onA, -factor * nx, -factor * ny, -factor * (armX * ny - armY * nx));
        double lever = g.armBX * ny - g.armBY * nx;
        rows.derive(row, onB, factor * nx, factor * ny, factor * lever);
    }

    /** Angle of B relative to A. */
    private int angle(int part, double place) {
        int row = row(part);
        rows.derive(row, a, 0, 0, -1);
        rows.derive(row, b, 0, 0, 1);
        return part == ANGLE ? equation(row, place) : row;
    }

    /** Row of the joint's coordinate, or of its negative. */
    private int alongCoordinate(int part, double sign) {
        int row = row(part);
        deriveCoordinate(row, slot, geometry, a, b, sign);
        return row;
    }

    private void deriveCoordinate(
            int row, int of, JointGeometry g, int onA, int onB, double factor) {
        if (joints.kind[of] == JointKind.REVOLUTE.ordinal()) {
            rows.derive(row, onA, 0, 0, -factor);
            rows.derive(row, onB, 0, 0, factor);
        } else {
            deriveAlong(row, g, onA, onB, g.axisX, g.axisY, factor);
        }
    }

    /** Adds limits, motor and spring of the coordinate. */
    private void coordinate() {
        limits();
        if (drives(joints.motorMost[slot])) {
            boolean isWheel = joints.kind[slot] == JointKind.WHEEL.ordinal();
            int row = isWheel ? angle(MOTOR, 0) : alongCoordinate(MOTOR, 1);
            drive(row, joints.motorSpeed[slot], joints.motorMost[slot]);
        }
        if (joints.stiffness[slot] > 0 && !isAtOnce) {
            double rest = isDistance() ? joints.parameter[JointStore.LENGTH][slot] : 0;
            int row = alongCoordinate(SPRING, 1);
            springs.write(slot, geometry.coordinate(slot) - rest);
            endSoft();
            if (row < rows.count && springs.isStiff) {
                bent.note(row);
            }
        }
    }

    /** Whether a motor with a limited force, N or N·m, has any effect. */
    private boolean drives(double most) {
        return isAtOnce ? most == Double.POSITIVE_INFINITY : most > 0;
    }

    private boolean isDistance() {
        return joints.kind[slot] == JointKind.DISTANCE.ordinal();
    }

    private void endSoft() {
        int row = rows.count - 1;
        rows.finish(row);
        if (rows.response[row] > 0) {
            springs.finish(row);
        } else {
            rows.count--;
        }
    }

    private void limits() {
        double lower = joints.lower[slot];
        double upper = joints.upper[slot];
        double now = geometry.coordinate(slot);
        if (lower == upper) {
            equation(alongCoordinate(LOWER, 1), now - lower);
            return;
        }
        if (lower > Double.NEGATIVE_INFINITY && !(isDistance() && lower == 0)) {
            push(alongCoordinate(LOWER, 1), now - lower);
        }
        if (upper < Double.POSITIVE_INFINITY) {
            push(alongCoordinate(UPPER, -1), upper - now);
        }
    }

    /** Row whose gap must not close; it only pushes. */
    private void push(int row, double gap) {
        int state = states.ofJoint(joint, rows.part[row]);
        rows.place[row] = gap;
        rows.holdsPlace[row] = true;
        if (state != RowStates.HELD) {
            rows.lower[row] = 0;
            rows.upper[row] = state == RowStates.OPEN ? 0 : Double.POSITIVE_INFINITY;
            boolean comesBack = areTaut() && gap < 0;
            rows.target[row] = comesBack ? taut.back(-gap, drift) : -Math.max(0, gap) / drift;
        }
        rows.elasticity[row] = joints.elasticity[slot];
        end(row);
    }

    private void drive(int row, double speed, double most) {
        rows.target[row] = speed;
        rows.upper[row] = most * Math.abs(kick);
        rows.lower[row] = -rows.upper[row];
        end(row);
    }

    private void distance() {
        boolean isSoft = joints.stiffness[slot] > 0;
        boolean isFree =
                joints.motorMost[slot] > 0
                        || joints.lower[slot] > Double.NEGATIVE_INFINITY
                        || joints.upper[slot] < Double.POSITIVE_INFINITY;
        if (!isSoft && !isFree) {
            double rest = joints.parameter[JointStore.LENGTH][slot];
            axis(X, geometry.axisX, geometry.axisY, geometry.along - rest);
        } else {
            coordinate();
        }
    }

    /** Draws the ends of a rod or rope back to its line, if it is taut. */
    private void across() {
        double force = lines.pull(joint);
        if (force > 0 && geometry.along > 0 && !isAtOnce) {
            int row = apart(Y, -geometry.axisY, geometry.axisX);
            rows.give[row] = TautLines.give(force, geometry.along, kick, drift);
            rows.target[row] = lines.kept() * rows.speed(row);
            end(row);
        }
    }

    private void motor() {
        double[][] p = joints.parameter;
        double force = p[JointStore.MOST_FORCE][slot];
        if (drives(force)) {
            int x = row(X);
            deriveAlong(x, geometry, a, b, geometry.axisX, geometry.axisY, 1);
            drive(x, p[JointStore.VELOCITY_X][slot], force);
            int y = row(Y);
            deriveAlong(y, geometry, a, b, -geometry.axisY, geometry.axisX, 1);
            drive(y, p[JointStore.VELOCITY_Y][slot], force);
            disc(x, y, force);
        }
        if (drives(p[JointStore.MOST_TORQUE][slot])) {
            int turn = angle(MOTOR, 0);
            drive(turn, p[JointStore.ANGULAR_VELOCITY][slot], p[JointStore.MOST_TORQUE][slot]);
        }
    }

    /** Bounds two rows together by a force, N. */
    private void disc(int x, int y, double force) {
        if (force < Double.POSITIVE_INFINITY) {
            rows.twin[x] = y;
            rows.twin[y] = x;
            rows.share[x] = force * Math.abs(kick);
            rows.share[y] = rows.share[x];
        }
    }

    /** The target takes the place of A and receives no reaction. */
    private void mouse() {
        if (isAtOnce) {
            return;
        }
        double awayX = geometry.fromTargetX(slot, b);
        double awayY = geometry.fromTargetY(slot, b);
        int x = row(X);
        rows.derive(x, b, 1, 0, -geometry.armBY);
        springs.writeImplicit(slot, awayX);
        rows.finish(x);
        springs.finish(x);
        int y = row(Y);
        rows.derive(y, b, 0, 1, geometry.armBX);
        springs.writeImplicit(slot, awayY);
        rows.finish(y);
        springs.finish(y);
        disc(x, y, joints.parameter[JointStore.MOST_FORCE][slot]);
    }

    private void gear() {
        int first = joints.firstGeared[slot];
        int second = joints.secondGeared[slot];
        double ratio = joints.parameter[JointStore.RATIO][slot];
        int firstA = packed.offset(joints.bodyA[first]);
        int secondA = packed.offset(joints.bodyA[second]);
        geometry.measure(first, firstA, a);
        other.measure(second, secondA, b);
        int row = row(X);
        deriveCoordinate(row, first, geometry, firstA, a, 1);
        deriveCoordinate(row, second, other, secondA, b, ratio);
        equation(row, geometry.gearError(slot, other));
        if (joints.kind[first] == JointKind.REVOLUTE.ordinal()) {
            // The sliding of a rack is counted by the angle that it turns.
            rows.unit[row] = rows.reach(row);
        }
    }

    private void pulley() {
        double ratio = joints.parameter[JointStore.RATIO][slot];
        int row = row(UPPER);
        pull(row, a, true, 1);
        pull(row, b, false, ratio);
        push(row, geometry.ropeLeft(slot, a, b));
    }

    private void pull(int row, int offset, boolean isOfA, double factor) {
        double x = geometry.ropeX(slot, offset, isOfA);
        double y = geometry.ropeY(slot, offset, isOfA);
        double length = Math.sqrt(x * x + y * y);
        if (length > 0) {
            double nx = -factor * x / length;
            double ny = -factor * y / length;
            double armX = isOfA ? geometry.armAX : geometry.armBX;
            double armY = isOfA ? geometry.armAY : geometry.armBY;
            rows.derive(row, offset, nx, ny, armX * ny - armY * nx);
        }
    }

    /** Whether a spring is too stiff for its substep. */
    boolean areAnyStiff() {
        return springs.areAnyStiff;
    }
}
