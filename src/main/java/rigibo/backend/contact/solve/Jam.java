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
 * Takes overlap back in an island that hardly moves and in which bodies are crushed: there may be
 * no room for them, and then recovery has to come to an end. All contacts push at once, each by a
 * share of its overlap, however deep that is. That goes down the slope of the sum of all overlaps
 * squared, which ends where pushes balance, in whatever order contacts are listed. The share is so
 * small that all those of one body together do not overshoot.
 */
final class Jam {

    /**
     * Share of the fastest pace at which recovery ends, 0.12 widths a second: the last of it would
     * take minutes, and goes to and fro where a contact turns to another face.
     */
    private static final double STILL = 0.04;

    /** Passes in a substep. */
    private static final int PASSES = 12;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;
    private final GroundHold ground;

    /** Where bodies were before overlap was taken back. */
    private final Displacement moved;

    /** By entry of the motions: how many contacts push it. */
    private int[] pushing = new int[16];

    /** By place in the list of contacts: what pushes its points apart, kg·m. */
    private double[] push0 = new double[16];

    private double[] push1 = new double[16];

    /** Share of an overlap that is taken back in a pass. */
    private double share;

    /** Overlap that stays, in widths. */
    private double kept;

    Jam(Bodies bodies, Motions motions, PackedContacts contacts, GroundHold ground) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
        this.ground = ground;
        moved = new Displacement(motions);
    }

    /**
     * Parts the contacts listed, in a substep of h seconds, but for what is kept, in widths; the
     * fastest body sets the pace of all. Nobody is moved where even that one would hardly go: such
     * an island is as far apart as it gets.
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
        double most = (1 - OverlapSolver.ROUND_OFF) * Recovery.MOST_PUSH * h;
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

    /** Makes room for the packed island. */
    void reserve() {
        if (pushing.length < motions.count) {
            pushing = new int[motions.slots.length];
        }
        if (push0.length < contacts.count) {
            push0 = new double[contacts.pair.length];
            push1 = new double[contacts.pair.length];
        }
    }

    /** The most contacts that push one body. */
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

    /** The farthest way of any point of a body, in its widths. */
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

    /** How far in m a point is to part in a pass. */
    private double wanted(int row, int point) {
        double width = contacts.data[row * PackedContacts.STRIDE + PackedContacts.WIDTH];
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
