package rigibo.backend.contact.solve;

import rigibo.backend.contact.row.Displacement;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Bodies;

/**
 * Limits how far removal of overlap moves a body. Each contact parts its two bodies within a limit
 * of speed, but the outermost of many overlapping bodies would move at the sum of these speeds.
 */
final class PartingLimit {

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;
    private final Displacement moved;

    PartingLimit(Bodies bodies, Motions motions, PackedContacts contacts) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
        moved = new Displacement(motions);
    }

    /** Stores the places of all bodies. */
    void begin() {
        if (contacts.areFloating()) {
            moved.begin();
        }
    }

    /**
     * Scales displacements down that exceed a number of widths of their body; the common centre of
     * mass stays in place.
     */
    void end(double widths) {
        if (!contacts.areFloating() || !holdBack(widths)) {
            return;
        }
        keepCentre();
        double common = 1;
        for (int entry = 1; entry < motions.count; entry++) {
            common = Math.min(common, share(entry, widths));
        }
        moved.scaleAll(common);
    }

    private boolean holdBack(double widths) {
        boolean isAny = false;
        for (int entry = 1; entry < motions.count; entry++) {
            double share = share(entry, widths);
            if (share < 1) {
                moved.scale(entry * Motions.STRIDE, share);
                isAny = true;
            }
        }
        return isAny;
    }

    /** Moves all bodies back by the displacement of their common centre of mass. */
    private void keepCentre() {
        double x = 0;
        double y = 0;
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            double own = 1 / motions.data[at + Motions.INVERSE_MASS];
            x += own * moved.of(at + Motions.DX);
            y += own * moved.of(at + Motions.DY);
        }
        double mass = motions.mass();
        motions.moveAll(-x / mass, -y / mass);
    }

    private double share(int entry, double widths) {
        int at = entry * Motions.STRIDE;
        double x = moved.of(at + Motions.DX);
        double y = moved.of(at + Motions.DY);
        double square = x * x + y * y;
        double most = widths * bodies.smallestWidth[motions.slots[entry]];
        return square > most * most ? most / Math.sqrt(square) : 1;
    }
}
