package rigibo.backend.contact.bounce;

import static rigibo.backend.contact.row.Motions.DX;
import static rigibo.backend.contact.row.Motions.DY;
import static rigibo.backend.contact.row.Motions.TURN;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * Displacements that the impacts of a substep cause: up to its impact each body went on with its
 * old velocity. Contacts do not hold it back before that; displacements that lead into another body
 * are taken back, as far as the energy lost in the impacts pays for the lift.
 */
final class ImpactShifts {

    /** x, y and turn of each entry of the motions. */
    private static final int STRIDE = 3;

    /** Rounds in which a shift may keep a share; from then on what leads into another is lost. */
    private static final int PARTLY = 4;

    private static final int MOST_ROUNDS = 16;

    /** The share from which on a shift leaves bodies apart, but for round-off. */
    private static final double APART = 1 - 1e-9;

    /** Way into another that does not show, as a share of the width. */
    private static final double UNSEEN = 1e-4;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;

    /** What the impacts took of the energy of motion, less what has been lifted for it, J. */
    private double taken;

    /** By entry of the motions, m and rad. */
    private double[] shifts = new double[16 * STRIDE];

    /** How long what parts goes on before it is to be apart, s. */
    private double ahead;

    /** Gap in widths, before anything was shifted, of the contacts that are asked. */
    private double widest;

    /** Way into another that is left, as a share of the width. */
    private double unseen;

    /** By entry of the motions the share of its shift that stays. */
    private double[] shares = new double[16];

    /** The contacts of those that were shifted. */
    private int[] asked = new int[16];

    private int askedCount;

    ImpactShifts(Bodies bodies, Motions motions, PackedContacts contacts) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Begins a substep in which there are impacts. */
    void begin() {
        if (shares.length < motions.count) {
            shares = new double[motions.slots.length];
            shifts = new double[motions.slots.length * STRIDE];
        }
        Arrays.fill(shifts, 0, motions.count * STRIDE, 0);
        taken = 0;
    }

    /** Notes that an impact took some J of the energy of motion. */
    void take(double energy) {
        taken += Math.max(0, energy);
    }

    /** Moves the body at an offset of the motions, m and rad; the ground stays. */
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
     * Takes back what leads into others. That may lead into the next ones, which the same shift had
     * left behind: so again, until all are apart or nothing is left.
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

    /** The energy in J that it takes to move a body back as far as it may not stay. */
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

    /** The share of their shifts that leaves the bodies of a contact apart. */
    private double shareOf(int row) {
        double share = 1;
        double width = contacts.data[row * PackedContacts.STRIDE + PackedContacts.WIDTH];
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

    /** What of a point's gap has come by shifts, m. */
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

    /** Takes back a share of what may not stay; what floats keeps its centre of mass. */
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
