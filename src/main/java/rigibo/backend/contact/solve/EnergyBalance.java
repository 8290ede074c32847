package rigibo.backend.contact.solve;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Bodies;

/**
 * Corrects the energy of an island of few bodies on immovable ones. These do no work, so that in a
 * step the kinetic energy may grow by no more than the work of weight. The error of a substep, of
 * second order, adds some energy, and removal of overlap lifts bodies without work; both are taken
 * from the motion.
 */
public final class EnergyBalance {

    /**
     * Largest share of the kinetic energy that is taken in a step: a body at rest in an overlap has
     * none.
     */
    private static final double MOST = 1e-2;

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

    /** Starts a step of the packed island. */
    public void begin() {
        isKept = motions.areFew() && !motions.isAnyDriven && !contacts.isAnyRunning && isAllKnown();
        motionBefore = isKept ? motions.energy(motions.data) : 0;
    }

    /** Whether the pulls are constant along the path and there is no drag. */
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

    /** Takes the energy gained without work from the motion. */
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

    /** Work of weights and torques in the step, J. */
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
