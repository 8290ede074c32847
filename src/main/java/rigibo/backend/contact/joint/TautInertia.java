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
 * oscillation is slow relative to the drift, the inertia stays as it is.
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

    private final JointStore joints;
    private final Motions motions;
    private final PackedJoints packed;
    private final Poses poses;

    /** By entry of the motions: 1/I, and Σ(r·F) in N·m. */
    private double[] inverseInertia = new double[16];

    private double[] stiffness = new double[16];

    TautInertia(DataStorage data, Motions motions, PackedJoints packed, Poses poses) {
        joints = data.jointsOrNone();
        this.motions = motions;
        this.packed = packed;
        this.poses = poses;
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
            int slot = packed.slot[i];
            if (joints.kind[slot] == REVOLUTE || joints.kind[slot] == WELD) {
                pull(i, slot, lastKick);
            }
        }
        for (int entry = 1; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE;
            double square = h * h * stiffness[entry] * inverseInertia[entry];
            double over = isWedged ? WEDGED * square : square - FOLLOWED;
            double share = 1 / (1 + Math.max(0, over));
            motions.data[at + Motions.INVERSE_INERTIA] = share * inverseInertia[entry];
            motions.data[at + Motions.SPIN] *= share;
        }
    }

    private void pull(int joint, int slot, double lastKick) {
        double x = packed.impulseOf(joint, JointRows.X) / lastKick;
        double y = packed.impulseOf(joint, JointRows.Y) / lastKick;
        int a = packed.offsetA[joint];
        int b = packed.offsetB[joint];
        add(a, joints.bodyA[slot], joints.anchorAX[slot], joints.anchorAY[slot], -x, -y);
        add(b, joints.bodyB[slot], joints.anchorBX[slot], joints.anchorBY[slot], x, y);
    }

    private void add(
            int offset, int body, double anchorX, double anchorY, double forceX, double forceY) {
        if (offset != 0) {
            double cos = poses.cos(body, offset);
            double sin = poses.sin(body, offset);
            double armX = cos * anchorX - sin * anchorY;
            double armY = sin * anchorX + cos * anchorY;
            stiffness[offset / Motions.STRIDE] += armX * forceX + armY * forceY;
        }
    }
}
