package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.KeptOverlap;

import java.util.Arrays;

/**
 * Removes overlap in an island that is eliminated as a whole. Bodies are displaced as impulses
 * would move them with their joints held, so that closing joints does not bring overlap back.
 */
final class JointedOverlap {

    /** Passes over the contacts; the next substep continues. */
    private static final int PASSES = 12;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;
    private final NeutralRows rows;
    private final RowElimination elimination;
    private final Accuracy accuracy;

    /**
     * Rows of points that overlap or that others could be moved into; and the least distance by
     * which each must open, m.
     */
    private int[] point = new int[16];

    private double[] wanted = new double[16];
    private int count;

    /**
     * By point: its push, kg·m. By two points: the opening of the first by a unit push of the
     * second, 1/kg.
     */
    private double[] push = new double[16];

    private double[] opens = new double[256];

    /** By row: the change of speed that joints ask for, m/s. */
    private double[] change = new double[64];

    /** Velocities of the motions, while their columns hold displacements. */
    private double[] kept = new double[64];

    JointedOverlap(
            Bodies bodies,
            Motions motions,
            PackedContacts contacts,
            NeutralRows rows,
            RowElimination elimination,
            Accuracy accuracy) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
        this.rows = rows;
        this.elimination = elimination;
        this.accuracy = accuracy;
    }

    /**
     * Removes overlap after a drift of h seconds, if any is deeper than {@code least}, in widths.
     */
    void correct(double h, double least) {
        if (!find(h, least)) {
            return;
        }
        int length = motions.count * Motions.STRIDE;
        reserve(length);
        System.arraycopy(motions.data, 0, kept, 0, length);
        holdJoints();
        for (int i = 0; i < count; i++) {
            rest();
            displace(point[i], 1);
            for (int k = 0; k < count; k++) {
                opens[k * count + i] = rows.speed(point[k]);
            }
        }
        solve();
        rest();
        for (int i = 0; i < count; i++) {
            if (push[i] > 0) {
                displace(point[i], push[i]);
            }
        }
        move(h);
    }

    /**
     * Lists the points that overlap, and those that others could be moved into; returns whether any
     * overlaps by more than {@code least} widths.
     */
    private boolean find(double h, double least) {
        count = 0;
        boolean isAny = false;
        double kept = KeptOverlap.of(contacts.areCrowd(), accuracy);
        for (int row = 0; row < rows.count; row++) {
            if (rows.isPoint(row)) {
                isAny |= find(row, kept, h) > least;
            }
        }
        return isAny;
    }

    /** Lists a point if need be; returns its overlap beyond what is kept, in widths. */
    private double find(int row, double kept, double h) {
        int contact = rows.contact[row];
        int at = contact * PackedContacts.STRIDE;
        double width = contacts.data[at + PackedContacts.WIDTH];
        double gap = motions.gap(contacts, contact, rows.part[row] - PackedContacts.IMPULSE0);
        double most = Recovery.MOST_PUSH;
        double parts = Recovery.opens(contacts, contact, gap, kept, h, most);
        double left = gap + kept * width;
        if (parts > 0 || left < most * width * h) {
            if (count == point.length) {
                point = Arrays.copyOf(point, 2 * count);
                wanted = Arrays.copyOf(wanted, 2 * count);
                push = Arrays.copyOf(push, 2 * count);
            }
            point[count] = row;
            wanted[count] = parts > 0 ? parts : -Math.max(0, left);
            push[count++] = 0;
        }
        return -left / width;
    }

    private void reserve(int length) {
        if (opens.length < count * count) {
            opens = new double[2 * count * count];
        }
        if (change.length < rows.count) {
            change = new double[rows.bodies.length];
        }
        if (kept.length < length) {
            kept = new double[motions.data.length];
        }
    }

    /** Holds equations and limits; brakes and motors let bodies be moved. */
    private void holdJoints() {
        for (int row = 0; row < rows.count; row++) {
            boolean isHeld = rows.isEquation(row) || rows.holdsPlace[row];
            if (!isHeld || rows.contact[row] != NeutralRows.NONE) {
                elimination.put(row, false);
            }
        }
        elimination.factorize();
    }

    private void rest() {
        for (int entry = 0; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE + Motions.VX;
            Arrays.fill(motions.data, at, at + 3, 0);
        }
    }

    /** Displaces bodies as a push of a row would with the joints held. */
    private void displace(int row, double amount) {
        rows.apply(row, amount);
        for (int i = 0; i < elimination.size(); i++) {
            change[elimination.row(i)] = -rows.speed(elimination.row(i));
        }
        elimination.solveFor(change);
        for (int i = 0; i < elimination.size(); i++) {
            rows.apply(elimination.row(i), elimination.answer(i));
        }
    }

    /** Finds the pushes by passes over the points. */
    private void solve() {
        for (int pass = 0; pass < PASSES; pass++) {
            for (int n = 0; n < count; n++) {
                int i = pass % 2 == 0 ? n : count - 1 - n;
                double own = Math.max(opens[i * count + i], least(i));
                double left = wanted[i];
                for (int k = 0; k < count; k++) {
                    left -= opens[i * count + k] * push[k];
                }
                push[i] = Math.max(0, push[i] + left / own);
            }
        }
    }

    /** Least response that is used, for points whose push joints hold nearly completely. */
    private double least(int i) {
        return Responses.LEAST * rows.response[point[i]];
    }

    /** Moves bodies by the displacements, scaled down if an outline would move too far. */
    private void move(double h) {
        double most = GroupVelocities.MOST_MOVED * Math.abs(h);
        double farthest = 0;
        double[] m = motions.data;
        for (int entry = 1; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE;
            double turning = Math.abs(m[at + Motions.SPIN]);
            double way =
                    Math.abs(m[at + Motions.VX])
                            + Math.abs(m[at + Motions.VY])
                            + (turning == 0 ? 0 : motions.reach[entry] * turning);
            double width = 2 * bodies.boundingRadius[motions.slots[entry]];
            farthest = Math.max(farthest, way / width);
        }
        double share = farthest > most ? most / farthest : 1;
        for (int entry = 0; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE;
            m[at + Motions.DX] += share * m[at + Motions.VX];
            m[at + Motions.DY] += share * m[at + Motions.VY];
            m[at + Motions.TURN] += share * m[at + Motions.SPIN];
            System.arraycopy(kept, at + Motions.VX, m, at + Motions.VX, 3);
        }
    }
}
