package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;

/**
 * Locked axes of bodies in the packed island. Along a locked axis a body has infinite mass, so that
 * its inverse mass M⁻¹ becomes P·M⁻¹·P, where P projects the axis out.
 */
public final class LockedAxes {

    private final Bodies bodies;
    private final Motions motions;

    /** The storage may hold bodies with locked axes. */
    public LockedAxes(Bodies bodies, Motions motions) {
        this.bodies = bodies;
        this.motions = motions;
    }

    /** 0 if the body at an offset is locked in x, otherwise 1. */
    public double freedomX(int offset) {
        return bodies.lockedX[motions.slots[offset / Motions.STRIDE]] ? 0 : 1;
    }

    /** 0 if the body at an offset is locked in y, otherwise 1. */
    public double freedomY(int offset) {
        return bodies.lockedY[motions.slots[offset / Motions.STRIDE]] ? 0 : 1;
    }

    /** Whether a body of the packed island has a locked axis. */
    public boolean areAny() {
        boolean areAny = false;
        for (int entry = 1; !areAny && entry < motions.count; entry++) {
            areAny = bodies.isHeldByAxis(motions.slots[entry]);
        }
        return areAny;
    }

    /** Sets all velocities along locked axes to 0. */
    public void hold() {
        double[] m = motions.data;
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            if (bodies.isDynamic(slot) && bodies.isHeldByAxis(slot)) {
                int at = entry * Motions.STRIDE;
                m[at + Motions.VX] *= freedomX(at);
                m[at + Motions.VY] *= freedomY(at);
            }
        }
    }
}
