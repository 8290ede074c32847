package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;

/**
 * Axes along which bodies of the packed island are kept from moving. Along such an axis a body is
 * as heavy as the ground: an impulse does nothing there, so that of an inverse mass M⁻¹ what is
 * left is P·M⁻¹·P, with P leaving the axis out.
 */
public final class LockedAxes {

    private final Bodies bodies;
    private final Motions motions;

    /** Of bodies of which one may be locked. */
    public LockedAxes(Bodies bodies, Motions motions) {
        this.bodies = bodies;
        this.motions = motions;
    }

    /** 0 where the body at an offset is kept from moving along x, else 1. */
    public double freedomX(int offset) {
        return bodies.lockedX[motions.slots[offset / Motions.STRIDE]] ? 0 : 1;
    }

    /** 0 where the body at an offset is kept from moving along y, else 1. */
    public double freedomY(int offset) {
        return bodies.lockedY[motions.slots[offset / Motions.STRIDE]] ? 0 : 1;
    }

    /** Whether a body of the packed island is locked. */
    public boolean areAny() {
        boolean areAny = false;
        for (int entry = 1; !areAny && entry < motions.count; entry++) {
            areAny = bodies.isHeldByAxis(motions.slots[entry]);
        }
        return areAny;
    }

    /** Takes all velocity along locked axes, which no force and no impulse gives. */
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
