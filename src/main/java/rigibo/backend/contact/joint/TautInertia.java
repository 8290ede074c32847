package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointStore;

import java.util.Arrays;

/**
 * Inertia that bodies have in a kick because what pulls at them turns them back as they go on. A
 * force F at an arm r gives a body that turns by δ a torque of −δ·(r·F): with the turn at the end
 * of a drift of h seconds, I·ω' = I·ω + τ·h − h²·(r·F)·ω'. So a body answers with I + h²·Σ(r·F) in
 * place of I, and trembling that no kick could follow dies away (M. Tournier, M. Nesme, B. Gilles
 * and F. Faure, Stable constrained dynamics, 2015, whose geometric stiffness is diagonal where
 * joints hold points). What is slow against the drift keeps its inertia.
 */
final class TautInertia {

    /** Square of the phase, in rad, that kicks follow as they are: of {@link TautSubsteps}. */
    private static final double FOLLOWED = TautSubsteps.MOST_PHASE * TautSubsteps.MOST_PHASE;

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

    /** Gives bodies their own inertia back. */
    void release() {
        for (int entry = 1; entry < motions.count; entry++) {
            motions.data[entry * Motions.STRIDE + Motions.INVERSE_INERTIA] = inverseInertia[entry];
        }
    }

    /**
     * Gives bodies, whose present poses are taken, the inertia of a kick before a drift of h
     * seconds, by what joints gave in the last kick, which was so many seconds long.
     */
    void stiffen(double lastKick, double h) {
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
            double share = square > FOLLOWED ? 1 / (1 + square - FOLLOWED) : 1;
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
