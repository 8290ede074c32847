package rigibo.backend.contact.joint;

import rigibo.backend.contact.hold.Equilibrium;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.JointStore;

/**
 * Tests whether the joints of an island at rest keep their forces: each is in its place, limits
 * only push, motors stay within their force, and springs pull by k·x. Nothing has to be remembered,
 * since any change of a limit, motor, spring or target shows in this test, and any change of a load
 * in the sums of forces.
 */
public final class JointsAtRest {

    /** Largest error of a place, as a share of the joint's arms and of the tolerance. */
    private static final double OFF_PLACE = 1e-2;

    private final Bodies bodies;
    private final Islands islands;
    private final JointStore joints;
    private final Motions motions;
    private final NeutralRows rows;
    private final PackedJoints packed;
    private final Poses poses;

    /** The states of stops: no stop is watched, so all rows are bound. */
    private final RowStates states;

    private final JointRows jointRows;
    private final JointResults results;
    private final double tolerance;

    /** A test of islands whose bodies {@code builder} packs into {@code motions}. */
    public JointsAtRest(DataStorage data, Motions motions, RowBuilder builder, Accuracy accuracy) {
        bodies = data.bodies;
        islands = data.islands;
        joints = data.jointsOrNone();
        this.motions = motions;
        // Forces that a locked axis takes do not count as held, so that such an island is solved.
        rows = new NeutralRows(motions, null);
        packed = new PackedJoints(data, builder);
        poses = new Poses(data.bodies, motions);
        states = new RowStates();
        jointRows = new JointRows(data, rows, packed, poses, states, new TautLines(packed));
        results = new JointResults(data, packed, rows);
        tolerance = accuracy.impactTolerance();
    }

    /** Whether no joint of the island holds to a driven body. */
    public boolean areStanding(int island) {
        for (int i = islands.jointStart[island]; i < islands.jointStart[island + 1]; i++) {
            int joint = islands.joints[i];
            int first = joints.firstGeared[joint];
            boolean isCarried =
                    first != JointStore.NONE
                            && (isDriven(first) || isDriven(joints.secondGeared[joint]));
            if (isCarried || isDriven(joint)) {
                return false;
            }
        }
        return true;
    }

    private boolean isDriven(int joint) {
        return bodies.isDriven(joints.bodyA[joint]) || bodies.isDriven(joints.bodyB[joint]);
    }

    /**
     * Whether the joints of a packed island keep their forces for a step of dt seconds; adds the
     * forces to the sums of the bodies.
     */
    public boolean goOn(int island, double dt, Equilibrium sums) {
        motions.halt();
        packed.pack(island, dt);
        states.clear(packed.count, 0);
        rows.clear();
        poses.take(0);
        jointRows.write(dt, dt);
        results.keepArms(poses);
        for (int row = 0; row < rows.count; row++) {
            double impulse = packed.impulseOf(rows.joint[row], rows.part[row]);
            rows.impulse[row] = isSoft(row) ? ofSpring(row) : impulse;
        }
        rows.bound();
        for (int row = 0; row < rows.count; row++) {
            if (!isSteady(row)) {
                return false;
            }
            add(row, dt, sums);
        }
        return true;
    }

    /** Whether a row is a spring: it has compliance, or a force that nothing else changes. */
    private boolean isSoft(int row) {
        boolean isFixed = rows.lower[row] == rows.upper[row];
        return rows.give[row] > 0 || isFixed && !rows.holdsPlace[row];
    }

    /** Impulse of a spring on bodies that stand still, N·s or N·m·s. */
    private double ofSpring(int row) {
        return rows.give[row] > 0 ? rows.target[row] / rows.give[row] : rows.upper[row];
    }

    private boolean isSteady(int row) {
        if (rows.holdsPlace[row]) {
            return isAtPlace(row);
        }
        double impulse = rows.impulse[row];
        double slack = Equilibrium.BEYOND_CONE * rows.upper[row];
        double target = rows.give[row] > 0 ? 0 : rows.target[row];
        // A motor is at rest if its largest force does not move anything.
        double least = target > 0 ? rows.upper[row] : rows.lower[row];
        double most = target < 0 ? rows.lower[row] : rows.upper[row];
        return rows.isEquation(row)
                ? target == 0
                : impulse >= least - slack && impulse <= most + slack;
    }

    private boolean isAtPlace(int row) {
        double off = rows.inMetres(row, rows.place[row]);
        jointRows.places.of(row);
        boolean isAt =
                off
                        <= OFF_PLACE * tolerance * jointRows.places.size()
                                + jointRows.places.roundOff();
        if (rows.isEquation(row)) {
            return isAt;
        }
        double impulse = rows.impulse[row];
        return impulse > 0 ? isAt : impulse == 0 && (isAt || rows.place[row] > 0);
    }

    private void add(int row, double dt, Equilibrium sums) {
        double force = rows.impulse[row] / dt;
        for (int i = 0; i < rows.bodies[row]; i++) {
            int at = row * NeutralRows.DERIVATIVES + 3 * i;
            int offset = rows.body[row * NeutralRows.BODIES + i];
            sums.add(
                    motions.slots[offset / Motions.STRIDE],
                    force * rows.derivative[at],
                    force * rows.derivative[at + 1],
                    force * rows.derivative[at + 2]);
        }
    }

    /** Stores the forces of joints that kept them for a step of dt seconds. */
    public void tell(double dt) {
        results.add();
        results.tell(dt);
        results.noteBreaks();
    }
}
