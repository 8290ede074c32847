package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.KeptOverlap;

/**
 * Removes overlap in an island whose equations are eliminated. Bodies are displaced as impulses
 * would move them, whole groups of joined bodies at once, so that joints stay closed.
 */
final class CrowdOverlap {

    /** Passes in a substep; the next substep continues. */
    private static final int PASSES = 6;

    private final Motions motions;
    private final PackedContacts contacts;
    private final NeutralRows rows;
    private final Responses responses;
    private final GroupVelocities velocities;
    private final Accuracy accuracy;

    /**
     * Rows of overlapping points, the distances by which they are to part, m, and their pushes,
     * kg·m.
     */
    private int[] deep = new int[16];

    private double[] wanted = new double[16];
    private double[] push = new double[16];
    private int count;

    CrowdOverlap(
            Motions motions,
            PackedContacts contacts,
            NeutralRows rows,
            Responses responses,
            GroupVelocities velocities,
            Accuracy accuracy) {
        this.motions = motions;
        this.contacts = contacts;
        this.rows = rows;
        this.responses = responses;
        this.velocities = velocities;
        this.accuracy = accuracy;
    }

    /** Removes overlap in a substep of h seconds whose rows are written. */
    void correct(double h) {
        find(h);
        if (count == 0) {
            return;
        }
        velocities.rest();
        for (int pass = 0; pass < PASSES; pass++) {
            for (int i = 0; i < count; i++) {
                part(pass % 2 == 0 ? i : count - 1 - i);
            }
        }
        velocities.move(h);
    }

    private void find(double h) {
        if (deep.length < rows.count) {
            deep = new int[rows.bodies.length];
            wanted = new double[rows.bodies.length];
            push = new double[rows.bodies.length];
        }
        count = 0;
        double kept = KeptOverlap.of(contacts.areCrowd(), accuracy);
        for (int row = 0; row < rows.count; row++) {
            if (rows.isPoint(row)) {
                find(row, kept, h);
            }
        }
    }

    private void find(int row, double kept, double h) {
        int point = rows.part[row] - PackedContacts.IMPULSE0;
        double gap = motions.gap(contacts, rows.contact[row], point);
        double opens =
                Recovery.opens(contacts, rows.contact[row], gap, kept, h, Recovery.MOST_PUSH);
        if (opens > 0) {
            deep[count] = row;
            wanted[count] = opens;
            push[count++] = 0;
        }
    }

    private void part(int i) {
        int row = deep[i];
        double left = wanted[i] - velocities.along(row);
        double after = Math.max(0, push[i] + left / responses.own(row));
        responses.push(row, after - push[i]);
        push[i] = after;
    }
}
