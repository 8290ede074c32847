package rigibo.backend.contact.solve;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

import rigibo.backend.storage.Bodies;

/**
 * The energy of an island of few bodies among what stands still: what stands does no work, so in a
 * step motion may gain no more than weight gives on the way. A substep's error is more than that or
 * less, of second order; and what is lifted out of an overlap is lifted by nobody. Both is taken
 * from the motion.
 */
public final class EnergyBalance {

    /** Share of the motion that is taken at most: what rests in an overlap has nothing to give. */
    private static final double MOST = 1e-3;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;

    private boolean isKept;
    private double motionBefore;

    public EnergyBalance(Bodies bodies, Motions motions, PackedContacts contacts) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Begins a step of the packed island. */
    public void begin() {
        isKept = motions.areFew() && !motions.isAnyDriven && !contacts.isAnyRunning && isAllKnown();
        motionBefore = isKept ? motions.energy(motions.data) : 0;
    }

    /** Whether what pulls is the same all along, and nothing drags. */
    private boolean isAllKnown() {
        boolean isKnown = true;
        for (int entry = 1; isKnown && entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            boolean changes =
                    bodies.pullX != null && (bodies.pullX[slot] != 0 || bodies.pullY[slot] != 0);
            boolean drags = bodies.drag != null && bodies.drag[slot] != 0;
            isKnown = !changes && !drags;
        }
        return isKnown;
    }

    /** Takes from the motion what it has gained out of nothing. */
    public void settle() {
        if (!isKept || contacts.groundStart == contacts.count) {
            return;
        }
        double motion = motions.energy(motions.data);
        double gain = Math.min(motion - motionBefore - work(), MOST * motion);
        if (gain > 0) {
            slowDown(Math.sqrt(1 - gain / motion));
        }
    }

    /** What weights and torques gave on the way, J. */
    private double work() {
        double sum = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            int at = entry * Motions.STRIDE;
            double inverseMass = motions.data[at + Motions.INVERSE_MASS];
            double inverseInertia = motions.data[at + Motions.INVERSE_INERTIA];
            double along =
                    bodies.accelerationX[slot] * motions.data[at + Motions.DX]
                            + bodies.accelerationY[slot] * motions.data[at + Motions.DY];
            sum += inverseMass > 0 ? along / inverseMass : 0;
            if (inverseInertia > 0) {
                double turn = motions.data[at + Motions.TURN];
                sum += bodies.angularAcceleration[slot] * turn / inverseInertia;
            }
        }
        return sum;
    }

    private void slowDown(double factor) {
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            motions.data[at + Motions.VX] *= factor;
            motions.data[at + Motions.VY] *= factor;
            motions.data[at + Motions.SPIN] *= factor;
        }
    }
}
