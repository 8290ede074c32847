package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.KeptOverlap;

/**
 * Removes overlap in an island with locked axes. Bodies are displaced as impulses of their rows
 * would move them, and these rows leave locked axes out.
 */
public final class RowOverlap {

    private final Motions motions;
    private final PackedContacts contacts;
    private final NeutralRows rows;
    private final Accuracy accuracy;

    RowOverlap(Motions motions, PackedContacts contacts, NeutralRows rows, Accuracy accuracy) {
        this.motions = motions;
        this.contacts = contacts;
        this.rows = rows;
        this.accuracy = accuracy;
    }

    /**
     * Passes over the rows that are written, up and down, in a substep of h seconds; all passes
     * together part two bodies no faster than {@link Recovery#MOST_PUSH}.
     */
    public void correct(double h, int passes) {
        double kept = KeptOverlap.of(contacts.areCrowd(), accuracy);
        for (int pass = 0; pass < passes; pass++) {
            for (int i = 0; i < rows.count; i++) {
                int row = pass % 2 == 0 ? i : rows.count - 1 - i;
                if (rows.contact[row] != NeutralRows.NONE && isPoint(row)) {
                    part(row, kept, h, Recovery.MOST_PUSH / passes);
                }
            }
        }
    }

    private boolean isPoint(int row) {
        int part = rows.part[row];
        return part == PackedContacts.IMPULSE0 || part == PackedContacts.IMPULSE1;
    }

    private void part(int row, double kept, double h, double speed) {
        int point = rows.part[row] - PackedContacts.IMPULSE0;
        double gap = motions.gap(contacts, rows.contact[row], point);
        double opens = Recovery.opens(contacts, rows.contact[row], gap, kept, h, speed);
        if (opens > 0) {
            rows.move(row, opens / rows.response[row], Motions.DX);
        }
    }
}
