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
 * Tells whether joints go on carrying what they carry, in an island whose bodies stand still: each
 * is at its place, pushes at a limit that it is at, drives with no more than it may, and springs
 * pull by k·x. Nothing is remembered for it: another limit, motor, spring or target shows here, and
 * a load that was added or removed shows in the sums of forces.
 */
public final class JointsAtRest {

    /** How far a place may be off, as a share of the joint's arms and of the tolerance. */
    private static final double OFF_PLACE = 1e-2;

    private final Bodies bodies;
    private final Islands islands;
    private final JointStore joints;
    private final Motions motions;
    private final NeutralRows rows;
    private final PackedJoints packed;
    private final Poses poses;

    /** Of which none is watched: all rows are bound. */
    private final RowStates states;

    private final JointRows jointRows;
    private final JointResults results;
    private final double tolerance;

    /** Of islands whose bodies {@code builder} packs into {@code motions}. */
    public JointsAtRest(DataStorage data, Motions motions, RowBuilder builder, Accuracy accuracy) {
        bodies = data.bodies;
        islands = data.islands;
        joints = data.jointsOrNone();
        this.motions = motions;
        // What a locked axis takes counts as not held, and is solved.
        rows = new NeutralRows(motions, null);
        packed = new PackedJoints(data, builder);
        poses = new Poses(data.bodies, motions);
        states = new RowStates();
        jointRows = new JointRows(data, rows, packed, poses, states);
        results = new JointResults(data, packed, rows);
        tolerance = accuracy.impactTolerance();
    }

    /** Whether nothing that joints of an island hold on to moves as it is told. */
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
     * Whether the joints of an island whose bodies are packed go on for a step of dt seconds; what
     * each of them does to its bodies is added to the sums.
     */
    public boolean goOn(int island, double dt, Equilibrium sums) {
        motions.halt();
        packed.pack(island, dt);
        states.clear(packed.count, 0);
        rows.clear();
        poses.take(0);
        jointRows.write(dt, dt);
        results.keepArms(poses);
        jointRows.measureAnew();
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

    /** A spring gives way, or is kicked by a force that nothing else changes. */
    private boolean isSoft(int row) {
        boolean isFixed = rows.lower[row] == rows.upper[row];
        return rows.give[row] > 0 || isFixed && !rows.holdsPlace[row];
    }

    /** What a spring does to bodies that stand still, N·s or N·m·s. */
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
        // What drives is at rest where all that it may give does not move it.
        double least = target > 0 ? rows.upper[row] : rows.lower[row];
        double most = target < 0 ? rows.lower[row] : rows.upper[row];
        return rows.isEquation(row)
                ? target == 0
                : impulse >= least - slack && impulse <= most + slack;
    }

    private boolean isAtPlace(int row) {
        double off = rows.inMetres(row, rows.place[row]);
        jointRows.place(row);
        boolean isAt = off <= OFF_PLACE * tolerance * jointRows.size() + jointRows.roundOff();
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

    /** Tells what the joints that go on for a step of dt seconds give their bodies in it. */
    public void tell(double dt) {
        results.add();
        results.tell(dt);
        results.noteBreaks();
    }
}
