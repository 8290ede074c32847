package rigibo.backend.contact.joint;

import static rigibo.backend.contact.row.PackedContacts.FRICTION;
import static rigibo.backend.contact.row.PackedContacts.GIVE;
import static rigibo.backend.contact.row.PackedContacts.IMPULSE0;
import static rigibo.backend.contact.row.PackedContacts.IMPULSE_R;
import static rigibo.backend.contact.row.PackedContacts.IMPULSE_T;
import static rigibo.backend.contact.row.PackedContacts.LEVER_A0;
import static rigibo.backend.contact.row.PackedContacts.LEVER_B0;
import static rigibo.backend.contact.row.PackedContacts.LEVER_TA;
import static rigibo.backend.contact.row.PackedContacts.LEVER_TB;
import static rigibo.backend.contact.row.PackedContacts.NEARING;
import static rigibo.backend.contact.row.PackedContacts.NX;
import static rigibo.backend.contact.row.PackedContacts.NY;
import static rigibo.backend.contact.row.PackedContacts.ROLLING;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.PairTolerances;

/** The packed contacts of an island as neutral rows, and their impulses back. */
final class ContactRows {

    /**
     * Largest load of a contact that motion explains: the speed that it would give its bodies if
     * they were free, as a multiple of the fastest motion or drive. A larger load is stress between
     * rows that contradict each other.
     */
    private static final double STRAINED = 1e4;

    private final Motions motions;
    private final PackedContacts contacts;
    private final NeutralRows rows;
    private final RowStates states;

    ContactRows(Motions motions, PackedContacts contacts, NeutralRows rows, RowStates states) {
        this.states = states;
        this.motions = motions;
        this.contacts = contacts;
        this.rows = rows;
    }

    /**
     * Adds rows for a kick after which nothing drifts, as if h seconds were left. A point that
     * carried a load stays loaded if it touches: the drift has closed it but for its curvature, for
     * round-off and for removed overlap. Otherwise any gap would let bodies fall freely, since no
     * time is left to close it.
     */
    void writeAtRest(double h, int substep) {
        int first = rows.count;
        write(h, substep);
        for (int row = first; row < rows.count; row++) {
            if (rows.isPoint(row)
                    && rows.impulse[row] > 0
                    && rows.place[row] <= PairTolerances.TOUCHING_GAP * width(row)) {
                int at = rows.contact[row] * PackedContacts.STRIDE;
                rows.target[row] = contacts.data[at + NEARING];
            }
        }
    }

    /** Adds rows for all contacts that take part in a substep of h seconds. */
    void write(double h, int substep) {
        for (int row = 0; row < contacts.count; row++) {
            if (contacts.firstSubstep[row] <= substep) {
                write(row, h);
            }
        }
    }

    private void write(int contact, double h) {
        double[] d = contacts.data;
        int at = contact * PackedContacts.STRIDE;
        int first = rows.count;
        int points = contacts.points[contact];
        for (int point = 0; point < points; point++) {
            int row = begin(contact, IMPULSE0 + point);
            double leverA = d[at + LEVER_A0 + 2 * point];
            double leverB = d[at + LEVER_B0 + 2 * point];
            derive(row, contact, d[at + NX], d[at + NY], leverA, leverB);
            double gap = motions.gap(contacts, contact, point);
            rows.place[row] = gap;
            rows.target[row] = d[at + NEARING] - Math.max(0, gap) / h;
            rows.give[row] = d[at + GIVE];
            rows.lower[row] = 0;
            if (contacts.isOutOfReach(contact)) {
                // It is watched, but a target from its gap would swamp the targets of other rows.
                rows.target[row] = 0;
                rows.upper[row] = 0;
            } else if (states.ofContact(contact, point) == RowStates.OPEN) {
                rows.upper[row] = 0;
            }
            end(row);
        }
        // A point whose push acts along locked axes alone has no row.
        int loads = rows.count - first;
        if (d[at + FRICTION] > 0 && rows.count > first) {
            int row = begin(contact, IMPULSE_T);
            derive(row, contact, -d[at + NY], d[at + NX], d[at + LEVER_TA], d[at + LEVER_TB]);
            rows.target[row] = contacts.surface[contact];
            bind(row, d[at + FRICTION], first, loads);
            rows.give[row] = PackedContacts.COMPLIANCE * rows.response[row];
        }
        if (d[at + ROLLING] > 0 && rows.count > first) {
            int row = begin(contact, IMPULSE_R);
            rows.derive(row, contacts.bodyA[contact], 0, 0, -1);
            rows.derive(row, contacts.bodyB[contact], 0, 0, 1);
            bind(row, d[at + ROLLING], first, loads);
        }
    }

    /**
     * Whether any contact carries more than motion explains: the fastest body at {@code fastest}
     * m/s, springs and motors.
     */
    boolean areStrained(double fastest) {
        double most = STRAINED * Math.max(fastest, strongestDrive());
        boolean areStrained = false;
        for (int row = 0; !areStrained && row < rows.count; row++) {
            areStrained = rows.isPoint(row) && rows.ownSpeed(row) > most;
        }
        return areStrained;
    }

    /** The greatest speed that a spring, motor or limit would give its bodies, m/s. */
    double strongestDrive() {
        double most = 0;
        for (int row = 0; row < rows.count; row++) {
            boolean isOfJoint = rows.joint[row] != NeutralRows.NONE;
            if (isOfJoint && (rows.give[row] > 0 || !rows.isEquation(row))) {
                most = Math.max(most, rows.ownSpeed(row));
            }
        }
        return most;
    }

    private int begin(int contact, int column) {
        int row = rows.add();
        rows.contact[row] = contact;
        rows.part[row] = column;
        rows.impulse[row] = contacts.data[contact * PackedContacts.STRIDE + column];
        return row;
    }

    private void derive(int row, int contact, double nx, double ny, double leverA, double leverB) {
        rows.derive(row, contacts.bodyA[contact], -nx, -ny, -leverA);
        rows.derive(row, contacts.bodyB[contact], nx, ny, leverB);
    }

    private void bind(int row, double share, int load, int loads) {
        rows.share[row] = share;
        rows.load[row] = load;
        rows.loads[row] = loads;
        end(row);
    }

    private void end(int row) {
        rows.finish(row);
        if (!(rows.response[row] > 0)) {
            rows.count--;
        }
    }

    /** Whether the island has contacts. */
    boolean areAny() {
        return contacts.count > 0;
    }

    /** Whether any contact carries an impulse. */
    boolean carry() {
        for (int row = 0; row < rows.count; row++) {
            if (rows.contact[row] != NeutralRows.NONE && rows.impulse[row] != 0) {
                return true;
            }
        }
        return false;
    }

    /** The smaller width of the two bodies of a contact's row, m. */
    double width(int row) {
        return contacts.width(rows.contact[row]);
    }

    /** Writes the impulses back to the contacts. */
    void store() {
        for (int row = 0; row < rows.count; row++) {
            if (rows.contact[row] != NeutralRows.NONE) {
                int at = rows.contact[row] * PackedContacts.STRIDE;
                contacts.data[at + rows.part[row]] = rows.impulse[row];
            }
        }
    }
}
