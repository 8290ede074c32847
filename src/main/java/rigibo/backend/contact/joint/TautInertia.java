package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointStore;

import java.util.Arrays;

/**
 * The effective inertia of bodies under tension. A force F at an arm r turns back a body that
 * turned by δ with the torque −δ·(r·F). With the angle at the end of a drift of h seconds, I·ω' =
 * I·ω + τ·h − h²·(r·F)·ω'. So the body responds with I + h²·Σ(r·F) in place of I, and vibrations
 * that kicks cannot follow decay (M. Tournier, M. Nesme, B. Gilles and F. Faure, Stable constrained
 * dynamics, 2015, whose geometric stiffness is diagonal for joints that hold points). If the
 * oscillation is slow relative to the drift, the inertia stays as it is. Of the spin before a kick
 * the share that {@link TautLines} keeps is not damped.
 */
final class TautInertia {

    /** Square of the phase up to which kicks follow, rad², as in {@link TautSubsteps}. */
    private static final double FOLLOWED = TautSubsteps.MOST_PHASE * TautSubsteps.MOST_PHASE;

    /**
     * Multiple of h²·Σ(r·F) that is added where no load explains the tension. The vibration there
     * is that of hinges that close, and what it turns links by opens them further.
     */
    private static final double WEDGED = 8;

    private static final int REVOLUTE = JointKind.REVOLUTE.ordinal();
    private static final int WELD = JointKind.WELD.ordinal();
    private static final int DISTANCE = JointKind.DISTANCE.ordinal();

    private final JointStore joints;
    private final Motions motions;
    private final PackedJoints packed;
    private final JointGeometry geometry;
    private final TautLines lines;

    /** By entry of the motions: 1/I, and Σ(r·F) in N·m. */
    private double[] inverseInertia = new double[16];

    private double[] stiffness = new double[16];

    TautInertia(
            DataStorage data, Motions motions, PackedJoints packed, Poses poses, TautLines lines) {
        joints = data.jointsOrNone();
        this.motions = motions;
        this.packed = packed;
        this.lines = lines;
        geometry = new JointGeometry(data.bodies, joints, poses);
    }

    /** Begins an island that was just packed, whose bodies have their own inertia. */
    void begin() {
        if (inverseInertia.length < motions.count) {
            inverseInertia = new double[motions.slots.length];
            stiffness = new double[motions.slots.length];
        }
        for (int entry = 1; entry < motions.count; entry++) {
            inverseInertia[entry] = motions.data[entry * Motions.STRIDE + Motions.INVERSE_INERTIA];
        }
    }

    /** Restores the bodies' own inertia. */
    void release() {
        for (int entry = 1; entry < motions.count; entry++) {
            motions.data[entry * Motions.STRIDE + Motions.INVERSE_INERTIA] = inverseInertia[entry];
        }
    }

    /**
     * Sets the inertia of bodies, whose present poses are taken, for a kick before a drift of h
     * seconds, by the impulses of joints in the last kick, which lasted {@code lastKick} seconds;
     * {@code isWedged} if no load explains them.
     */
    void stiffen(double lastKick, double h, boolean isWedged) {
        Arrays.fill(stiffness, 0, motions.count, 0);
        for (int i = 0; i < packed.count; i++) {
            int kind = joints.kind[packed.slot[i]];
            if (kind == REVOLUTE || kind == WELD) {
                measure(i);
                double x = packed.impulseOf(i, JointRows.X) / lastKick;
                double y = packed.impulseOf(i, JointRows.Y) / lastKick;
                pull(i, x, y);
            } else if (kind == DISTANCE) {
                measure(i);
                double force = lines.pull(i);
                pull(i, -force * geometry.axisX, -force * geometry.axisY);
            }
        }
        for (int entry = 1; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE;
            double square = h * h * stiffness[entry] * inverseInertia[entry];
            double over = isWedged ? WEDGED * square : square - FOLLOWED;
            double share = 1 / (1 + Math.max(0, over));
            motions.data[at + Motions.INVERSE_INERTIA] = share * inverseInertia[entry];
            motions.data[at + Motions.SPIN] *= lines.kept() + (1 - lines.kept()) * share;
        }
    }

    private void measure(int joint) {
        geometry.measure(packed.slot[joint], packed.offsetA[joint], packed.offsetB[joint]);
    }

    /** Adds the force on B of a joint that was measured, N. */
    private void pull(int joint, double x, double y) {
        int a = packed.offsetA[joint] / Motions.STRIDE;
        int b = packed.offsetB[joint] / Motions.STRIDE;
        stiffness[a] -= geometry.armAX * x + geometry.armAY * y;
        stiffness[b] += geometry.armBX * x + geometry.armBY * y;
    }
}
