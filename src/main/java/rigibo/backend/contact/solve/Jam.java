package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.Motions.DX;
import static rigibo.backend.contact.row.Motions.DY;
import static rigibo.backend.contact.row.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.TURN;

import rigibo.backend.contact.row.Displacement;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * Removes overlap in a calm island with crushed bodies. There may be no room for them, and removal
 * then has to come to an end. All contacts push at once, each by a share of its overlap, however
 * deep. That is gradient descent on the sum of all squared overlaps; it ends where the pushes
 * balance and does not depend on the order of contacts. The share is small enough for all contacts
 * of one body together not to overshoot.
 */
final class Jam {

    /**
     * Share of the fastest rate of removal at which it ends, 0.12 widths per second. The rest would
     * take minutes, and oscillates where a contact changes to another face.
     */
    private static final double STILL = 0.04;

    /** Passes per substep. */
    private static final int PASSES = 12;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;
    private final GroundHold ground;

    /** Displacements since the start of the removal. */
    private final Displacement moved;

    /** By entry of the motions: number of contacts that push it. */
    private int[] pushing = new int[16];

    /** By place in the list of contacts: push at its first point, kg·m. */
    private double[] push0 = new double[16];

    /** By place in the list of contacts: push at its second point, kg·m. */
    private double[] push1 = new double[16];

    /** Share of an overlap that is removed in a pass. */
    private double share;

    /** Kept overlap, in widths. */
    private double kept;

    Jam(Bodies bodies, Motions motions, PackedContacts contacts, GroundHold ground) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
        this.ground = ground;
        moved = new Displacement(motions);
    }

    /**
     * Removes the overlap of the listed contacts beyond the kept one (widths), in a substep of h
     * seconds; the fastest body sets the pace of all. If even that one would hardly move, no body
     * is moved, since the island cannot be separated further.
     */
    void part(int[] deep, int count, double kept, double h, int substep) {
        moved.begin();
        this.kept = kept;
        double rate = Recovery.RATE * h;
        share = Math.min(rate / (1 + rate), 1.0 / mostPushing(deep, count));
        for (int pass = 0; pass < PASSES; pass++) {
            pass(deep, count);
            ground.hold(substep);
        }
        double way = farthest();
        double most = Recovery.mostWay(h);
        if (way <= STILL * most) {
            moved.scaleAll(0);
        } else if (way > most) {
            moved.scaleAll(most / way);
            ground.hold(substep);
        }
    }

    private void pass(int[] deep, int count) {
        for (int i = 0; i < count; i++) {
            find(deep[i], i);
        }
        for (int i = 0; i < count; i++) {
            move(deep[i], push0[i], push1[i]);
        }
    }

    /** Grows the arrays to the packed island. */
    void reserve() {
        if (pushing.length < motions.count) {
            pushing = new int[motions.slots.length];
        }
        if (push0.length < contacts.count) {
            push0 = new double[contacts.pair.length];
            push1 = new double[contacts.pair.length];
        }
    }

    /** Largest number of contacts that push one body. */
    private int mostPushing(int[] deep, int count) {
        Arrays.fill(pushing, 0, motions.count, 0);
        int most = 1;
        for (int i = 0; i < count; i++) {
            most = Math.max(most, countPush(contacts.bodyA[deep[i]]));
            most = Math.max(most, countPush(contacts.bodyB[deep[i]]));
        }
        return most;
    }

    private int countPush(int body) {
        return motions.data[body + INVERSE_MASS] > 0 ? ++pushing[body / Motions.STRIDE] : 0;
    }

    /** Largest displacement of any point of a body, in its widths. */
    private double farthest() {
        double most = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            int at = entry * Motions.STRIDE;
            double way = Math.abs(moved.of(at + DX)) + Math.abs(moved.of(at + DY));
            way += bodies.boundingRadius[slot] * Math.abs(moved.of(at + TURN));
            most = Math.max(most, way / bodies.smallestWidth[slot]);
        }
        return most;
    }

    private void find(int row, int i) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        double want0 = wanted(row, 0);
        double want1 = contacts.points[row] == 2 ? wanted(row, 1) : 0;
        double both0 = d[at + PackedContacts.M00] * want0 + d[at + PackedContacts.M01] * want1;
        double both1 = d[at + PackedContacts.M01] * want0 + d[at + PackedContacts.M11] * want1;
        if (want1 == 0 || both1 < 0) {
            both0 = want0 / d[at + PackedContacts.K00];
            both1 = 0;
        } else if (want0 == 0 || both0 < 0) {
            both0 = 0;
            both1 = want1 / d[at + PackedContacts.K11];
        }
        push0[i] = both0;
        push1[i] = both1;
    }

    /** Distance by which a point is to part in a pass, m. */
    private double wanted(int row, int point) {
        double width = contacts.width(row);
        double overlap = -motions.gap(contacts, row, point) - kept * width;
        return overlap > 0 ? overlap * share : 0;
    }

    private void move(int row, double first, double second) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        double x = (first + second) * d[at + PackedContacts.NX];
        double y = (first + second) * d[at + PackedContacts.NY];
        double onA =
                first * d[at + PackedContacts.LEVER_A0] + second * d[at + PackedContacts.LEVER_A1];
        double onB =
                first * d[at + PackedContacts.LEVER_B0] + second * d[at + PackedContacts.LEVER_B1];
        move(contacts.bodyA[row], -x, -y, -onA);
        move(contacts.bodyB[row], x, y, onB);
    }

    private void move(int body, double x, double y, double turn) {
        double[] m = motions.data;
        m[body + DX] += m[body + INVERSE_MASS] * x;
        m[body + DY] += m[body + INVERSE_MASS] * y;
        m[body + TURN] += m[body + INVERSE_INERTIA] * turn;
    }
}
