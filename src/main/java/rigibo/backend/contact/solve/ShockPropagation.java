package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.SPIN;
import static rigibo.backend.contact.row.Motions.VX;
import static rigibo.backend.contact.row.Motions.VY;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Bodies;

/**
 * Hands down, from storey to storey and to the ground, the impulses that stop bodies from sinking
 * in: one sweep from the top replaces passes whose number grows with the square of the number of
 * storeys. Each body is stopped as if its supports were already as slow as they will be ({@link
 * Supports}), and the supports get the opposite impulse. Momentum is kept, impulses only grow, and
 * the passes that follow correct errors.
 *
 * <p>The idea is that of shock propagation (Guendelman, Bridson and Fedkiw, <i>Nonconvex Rigid
 * Bodies with Stacking</i>, 2003), from the top down and with the supports free to move.
 */
public final class ShockPropagation {

    /** Rounds in which the points below a body share the rest to be stopped. */
    private static final int ROUNDS = 8;

    private final Motions motions;
    private final PackedContacts contacts;
    private final Supports supports;

    /** By point: impulse before, N·s. */
    private double[] before = new double[32];

    /** By point: speed at which it may close because of its gap, m/s. */
    private double[] spare;

    /** Speed up to which points may close faster than that, in widths per second. */
    private double allowed;

    /** By entry of the motions: sum of its changes of speed in the present sweep, m/s. */
    private double[] changed;

    public ShockPropagation(Bodies bodies, Motions motions, PackedContacts contacts) {
        this.motions = motions;
        this.contacts = contacts;
        supports = new Supports(bodies, motions, contacts);
    }

    /**
     * Hands impulses down in a substep.
     *
     * @param spare by point: speed at which it may close because of its gap, m/s
     * @param changed by entry: sum of its changes of speed, to which those by impulses are added
     * @param allowed speed up to which they may close faster than that, in widths per second
     */
    void handDown(int substep, double[] spare, double[] changed, double allowed) {
        if (!supports.find(substep, spare)) {
            return;
        }
        this.spare = spare;
        this.changed = changed;
        this.allowed = allowed;
        remember();
        for (int i = supports.count - 1; i >= 0; i--) {
            int entry = supports.order[i];
            for (int round = 0; round < ROUNDS && isClosing(entry); round++) {
                stop(entry);
            }
        }
    }

    private void remember() {
        if (before.length < 2 * contacts.count) {
            before = new double[2 * contacts.pair.length];
        }
        for (int row = 0; row < contacts.count; row++) {
            int at = row * PackedContacts.STRIDE;
            before[2 * row] = contacts.data[at + PackedContacts.IMPULSE0];
            before[2 * row + 1] = contacts.data[at + PackedContacts.IMPULSE1];
        }
    }

    /** Whether a body closes on what holds it by more than is allowed. */
    private boolean isClosing(int entry) {
        boolean isClosing = false;
        for (int row = supports.firstBelow(entry); row != Supports.NONE; ) {
            double width = contacts.width(row);
            for (int point = 0;
                    supports.isHeldBelow(row) && point < contacts.points[row];
                    point++) {
                isClosing |= parting(row, point, entry) < -allowed * width;
            }
            row = supports.nextBelow(row);
        }
        return isClosing;
    }

    /** Speed at which a point parts if its support is as fast as possible, m/s. */
    private double parting(int row, int point, int entry) {
        double[] m = motions.data;
        int upper = entry * Motions.STRIDE;
        int at = row * PackedContacts.STRIDE;
        double sign = supports.isAUpper(row) ? 1 : -1;
        double along =
                contacts.data[at + PackedContacts.NX] * m[upper + VX]
                        + contacts.data[at + PackedContacts.NY] * m[upper + VY];
        return supports.givesWay(row)
                + spare[2 * row + point]
                - sign * along
                - supports.leverOfUpper(row, point) * m[upper + SPIN];
    }

    /** Stops a body: all points that press take an equal share at the same time. */
    private void stop(int entry) {
        int upper = entry * Motions.STRIDE;
        double[] m = motions.data;
        double share = 1.0 / Math.max(1, pressing(entry));
        double vx = 0;
        double vy = 0;
        double spin = 0;
        for (int row = supports.firstBelow(entry); row != Supports.NONE; ) {
            int at = row * PackedContacts.STRIDE;
            double sign = supports.isAUpper(row) ? 1 : -1;
            double nx = sign * contacts.data[at + PackedContacts.NX];
            double ny = sign * contacts.data[at + PackedContacts.NY];
            for (int point = 0;
                    supports.isHeldBelow(row) && point < contacts.points[row];
                    point++) {
                double more = more(row, point, entry, share);
                if (more != 0) {
                    double lever = supports.leverOfUpper(row, point);
                    contacts.data[at + PackedContacts.IMPULSE0 + point] += more;
                    vx -= m[upper + INVERSE_MASS] * more * nx;
                    vy -= m[upper + INVERSE_MASS] * more * ny;
                    spin -= m[upper + INVERSE_INERTIA] * more * lever;
                    note(upper, more, lever);
                    push(supports.lower(row), more, nx, ny, supports.leverOfLower(row, point));
                }
            }
            contacts.work.contactSolves++;
            row = supports.nextBelow(row);
        }
        m[upper + VX] += vx;
        m[upper + VY] += vy;
        m[upper + SPIN] += spin;
    }

    /** Number of points below a body that close or have been given an impulse. */
    private int pressing(int entry) {
        int pressing = 0;
        for (int row = supports.firstBelow(entry); row != Supports.NONE; ) {
            for (int point = 0;
                    supports.isHeldBelow(row) && point < contacts.points[row];
                    point++) {
                boolean presses = given(row, point) > 0 || parting(row, point, entry) < 0;
                pressing += presses ? 1 : 0;
            }
            row = supports.nextBelow(row);
        }
        return pressing;
    }

    /** Impulse that a point was given so far, N·s. */
    private double given(int row, int point) {
        int at = row * PackedContacts.STRIDE + PackedContacts.IMPULSE0 + point;
        return contacts.data[at] - before[2 * row + point];
    }

    /** Impulse by which a point stops its share, N·s; at most it takes back its earlier impulse. */
    private double more(int row, int point, int entry, double share) {
        int upper = entry * Motions.STRIDE;
        double lever = supports.leverOfUpper(row, point);
        double turned = motions.data[upper + INVERSE_INERTIA] * lever * lever;
        double inverse = motions.data[upper + INVERSE_MASS] + turned;
        return Math.max(-given(row, point), -share * parting(row, point, entry) / inverse);
    }

    /** Applies an impulse along (nx, ny) to a body. */
    private void push(int at, double impulse, double nx, double ny, double lever) {
        double[] m = motions.data;
        m[at + VX] += m[at + INVERSE_MASS] * impulse * nx;
        m[at + VY] += m[at + INVERSE_MASS] * impulse * ny;
        m[at + SPIN] += m[at + INVERSE_INERTIA] * impulse * lever;
        note(at, impulse, lever);
    }

    /** Adds the change of speed by an impulse to the sum of a body's changes. */
    private void note(int at, double impulse, double lever) {
        int entry = at / Motions.STRIDE;
        double turned = motions.reach[entry] * motions.data[at + INVERSE_INERTIA] * Math.abs(lever);
        changed[entry] += Math.abs(impulse) * (motions.data[at + INVERSE_MASS] + turned);
    }
}
