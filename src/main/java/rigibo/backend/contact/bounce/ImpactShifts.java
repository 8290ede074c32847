package rigibo.backend.contact.bounce;

import static rigibo.backend.contact.row.Motions.DX;
import static rigibo.backend.contact.row.Motions.DY;
import static rigibo.backend.contact.row.Motions.TURN;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * Displacements caused by the impacts of a substep. Drift moves a body through the whole substep at
 * its new velocity, while it really moved at its old velocity up to the impact; the shift corrects
 * its place. No contact stops such a shift, so shifts that lead into another body are taken back,
 * as far as the energy lost in the impacts covers the lift.
 */
final class ImpactShifts {

    /** x, y and turn of each entry of the motions. */
    private static final int STRIDE = 3;

    /**
     * Rounds in which a shift can be shortened; later, a shift that leads into a body is dropped.
     */
    private static final int PARTLY = 4;

    private static final int MOST_ROUNDS = 16;

    /** Share of a shift from which on it counts as whole; the rest is round-off. */
    private static final double APART = 1 - 1e-9;

    /** Overlap by shifts that is neglected, in widths. */
    private static final double UNSEEN = 1e-4;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;

    /** Kinetic energy lost in the impacts, less the energy spent on lifting bodies back, J. */
    private double taken;

    /** By entry of the motions: its shift, m and rad. */
    private double[] shifts = new double[16 * STRIDE];

    /** Time, s, during which bodies that part still separate before they have to be apart. */
    private double ahead;

    /** Largest gap, in widths, that a contact may have had before the shift to be asked. */
    private double widest;

    /** Overlap by the shift that is left, in widths. */
    private double unseen;

    /** By entry of the motions: the share of its shift that is kept. */
    private double[] shares = new double[16];

    /** The contacts of shifted bodies. */
    private int[] asked = new int[16];

    private int askedCount;

    ImpactShifts(Bodies bodies, Motions motions, PackedContacts contacts) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Starts a substep with impacts. */
    void begin() {
        if (shares.length < motions.count) {
            shares = new double[motions.slots.length];
            shifts = new double[motions.slots.length * STRIDE];
        }
        Arrays.fill(shifts, 0, motions.count * STRIDE, 0);
        taken = 0;
    }

    /** Records the kinetic energy that an impact took, J. */
    void take(double energy) {
        taken += Math.max(0, energy);
    }

    /** Shifts the body at an offset of the motions, m and rad; the ground is not shifted. */
    void shift(int at, double x, double y, double turn) {
        motions.data[at + DX] += x;
        motions.data[at + DY] += y;
        motions.data[at + TURN] += turn;
        int i = at / Motions.STRIDE * STRIDE;
        if (i > 0) {
            shifts[i] += x;
            shifts[i + 1] += y;
            shifts[i + 2] += turn;
        }
    }

    /** Takes back what leads into others where they are now, and shows. */
    void limit(int substep) {
        ahead = 0;
        widest = Double.POSITIVE_INFINITY;
        unseen = UNSEEN;
        limitAsked(substep);
    }

    /**
     * Takes back what leads bodies that touched already, to a gap in widths, farther into each
     * other than a share of their width, unless they part again within {@code later} seconds.
     */
    void limitOfTouching(int substep, double gap, double later, double share) {
        ahead = later;
        widest = gap;
        unseen = share;
        limitAsked(substep);
    }

    /**
     * Takes back shifts that lead into other bodies. A body that goes back may meet one that had
     * been shifted along with it, so this is repeated until none overlaps or no shift is left.
     */
    private void limitAsked(int substep) {
        listContacts(substep);
        for (int round = 0; round < MOST_ROUNDS; round++) {
            Arrays.fill(shares, 0, motions.count, 1);
            if (!isAnyInto(round < PARTLY)) {
                return;
            }
            double lifts = 0;
            for (int entry = 1; entry < motions.count; entry++) {
                lifts += lift(entry);
            }
            double paid = lifts > taken ? taken / lifts : 1;
            takeBack(paid);
            taken -= paid * Math.max(0, lifts);
            if (paid < 1) {
                return;
            }
        }
    }

    /** Energy that it takes to move a body back by the part of its shift that is not kept, J. */
    private double lift(int entry) {
        int i = entry * STRIDE;
        double inverseMass = motions.data[entry * Motions.STRIDE + Motions.INVERSE_MASS];
        if (shares[entry] == 1 || inverseMass == 0) {
            return 0;
        }
        int slot = motions.slots[entry];
        double along =
                bodies.accelerationX[slot] * shifts[i] + bodies.accelerationY[slot] * shifts[i + 1];
        return (1 - shares[entry]) * along / inverseMass;
    }

    private void listContacts(int substep) {
        if (asked.length < contacts.count) {
            asked = new int[contacts.pair.length];
        }
        askedCount = 0;
        for (int row = 0; row < contacts.count; row++) {
            boolean isAsked = isShifted(contacts.bodyA[row]) || isShifted(contacts.bodyB[row]);
            if (isAsked && contacts.firstSubstep[row] <= substep) {
                asked[askedCount++] = row;
            }
        }
    }

    private boolean isShifted(int at) {
        int i = at / Motions.STRIDE * STRIDE;
        return shifts[i] != 0 || shifts[i + 1] != 0 || shifts[i + 2] != 0;
    }

    private boolean isAnyInto(boolean isPartly) {
        boolean isAny = false;
        for (int i = 0; i < askedCount; i++) {
            int row = asked[i];
            double share = shareOf(row);
            if (share < APART) {
                isAny = true;
                lessen(contacts.bodyA[row], isPartly ? share : 0);
                lessen(contacts.bodyB[row], isPartly ? share : 0);
            }
        }
        return isAny;
    }

    private void lessen(int at, double share) {
        int entry = at / Motions.STRIDE;
        shares[entry] = Math.min(shares[entry], share);
    }

    /** Largest share of their shifts at which the bodies of a contact do not overlap. */
    private double shareOf(int row) {
        double share = 1;
        double width = contacts.width(row);
        for (int point = 0; point < contacts.points[row]; point++) {
            double gap = motions.gap(contacts, row, point);
            if (ahead > 0 && gap < 0) {
                gap += ahead * Math.max(0, motions.parting(contacts, row, point));
            }
            double opened = gap < 0 ? opened(row, point) : 0;
            if (opened < 0 && gap - opened <= widest * width) {
                share = Math.min(share, (Math.max(0, gap - opened) + unseen * width) / -opened);
            }
        }
        return share;
    }

    /** Change of a point's gap by the shifts, m. */
    private double opened(int row, int point) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        int a = contacts.bodyA[row] / Motions.STRIDE * STRIDE;
        int b = contacts.bodyB[row] / Motions.STRIDE * STRIDE;
        return d[at + PackedContacts.NX] * (shifts[b] - shifts[a])
                + d[at + PackedContacts.NY] * (shifts[b + 1] - shifts[a + 1])
                + d[at + 2 * point + PackedContacts.LEVER_B0] * shifts[b + 2]
                - d[at + 2 * point + PackedContacts.LEVER_A0] * shifts[a + 2];
    }

    /** Takes back the parts that are not kept; floating islands keep their centre of mass. */
    private void takeBack(double paid) {
        double massTimesX = 0;
        double massTimesY = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE;
            int i = entry * STRIDE;
            double back = -paid * (1 - shares[entry]);
            double inverseMass = motions.data[at + Motions.INVERSE_MASS];
            if (back != 0 && inverseMass > 0) {
                massTimesX += back * shifts[i] / inverseMass;
                massTimesY += back * shifts[i + 1] / inverseMass;
                shift(at, back * shifts[i], back * shifts[i + 1], back * shifts[i + 2]);
            }
        }
        if (contacts.areFloating()) {
            double mass = motions.mass();
            motions.moveAll(-massTimesX / mass, -massTimesY / mass);
        }
    }
}
