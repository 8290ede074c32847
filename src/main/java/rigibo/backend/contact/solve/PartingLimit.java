package rigibo.backend.contact.solve;

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

    /** Where all entries were, laid out as the motions. */
    private double[] before = new double[16 * Motions.STRIDE];

    PartingLimit(Bodies bodies, Motions motions, PackedContacts contacts) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Notes where all bodies are. */
    void begin() {
        if (!contacts.areFloating()) {
            return;
        }
        int length = motions.count * Motions.STRIDE;
        if (before.length < length) {
            before = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, before, 0, length);
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
        for (int entry = 1; entry < motions.count; entry++) {
            scale(entry * Motions.STRIDE, common);
        }
    }

    private boolean holdBack(double widths) {
        boolean isAny = false;
        for (int entry = 1; entry < motions.count; entry++) {
            double share = share(entry, widths);
            if (share < 1) {
                scale(entry * Motions.STRIDE, share);
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
            x += own * (motions.data[at + Motions.DX] - before[at + Motions.DX]);
            y += own * (motions.data[at + Motions.DY] - before[at + Motions.DY]);
        }
        double mass = motions.mass();
        motions.moveAll(-x / mass, -y / mass);
    }

    private double share(int entry, double widths) {
        int at = entry * Motions.STRIDE;
        double x = motions.data[at + Motions.DX] - before[at + Motions.DX];
        double y = motions.data[at + Motions.DY] - before[at + Motions.DY];
        double square = x * x + y * y;
        double most = widths * bodies.smallestWidth[motions.slots[entry]];
        return square > most * most ? most / Math.sqrt(square) : 1;
    }

    private void scale(int at, double share) {
        for (int column = at + Motions.DX; column <= at + Motions.TURN; column++) {
            double moved = motions.data[column] - before[column];
            motions.data[column] = before[column] + share * moved;
        }
    }
}
