package rigibo.backend.contact.solve;

import rigibo.backend.contact.row.Displacement;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Bodies;

/**
 * Limits how far recovery moves a body. Each contact parts its two bodies within a speed limit, but
 * the outermost of many overlapping bodies would move at the sum of all of them.
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

    /** Notes where all bodies are. */
    void begin() {
        if (contacts.areFloating()) {
            moved.begin();
        }
    }

    /**
     * Takes back what has moved a body by more than so many of its widths since; the centre of mass
     * stays.
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

    /** Moves all by what the centre of mass has moved since, the other way. */
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
