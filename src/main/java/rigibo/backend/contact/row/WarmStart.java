package rigibo.backend.contact.row;

import static rigibo.backend.contact.row.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.SPIN;
import static rigibo.backend.contact.row.Motions.VX;
import static rigibo.backend.contact.row.Motions.VY;

/**
 * Warm starts a kick from the impulses of the last one, scaled by the lengths of the two. A load
 * lasts for at least two kicks, an impact for one only, and a start from an impact would throw its
 * body back. So the start is limited to a multiple of the impulse in the kick before the last.
 */
public final class WarmStart {

    private final Motions motions;
    private final PackedContacts contacts;

    public WarmStart(Motions motions, PackedContacts contacts) {
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Sets the impulses of the last two kicks to the packed island's stored ones. */
    public void prepare() {
        for (int at = 0; at < contacts.count * PackedContacts.STRIDE; at += PackedContacts.STRIDE) {
            keep(at);
        }
    }

    /** Limits every impulse to a multiple of that in the kick before. */
    public void leaveOutImpacts(double growth) {
        double[] d = contacts.data;
        for (int at = 0; at < contacts.count * PackedContacts.STRIDE; at += PackedContacts.STRIDE) {
            double j0 =
                    Math.min(
                            d[at + PackedContacts.IMPULSE0],
                            growth * d[at + PackedContacts.BEFORE0]);
            double j1 =
                    Math.min(
                            d[at + PackedContacts.IMPULSE1],
                            growth * d[at + PackedContacts.BEFORE1]);
            double both = d[at + PackedContacts.IMPULSE0] + d[at + PackedContacts.IMPULSE1];
            double share = both > 0 ? (j0 + j1) / both : 0;
            keep(at);
            d[at + PackedContacts.IMPULSE0] = j0;
            d[at + PackedContacts.IMPULSE1] = j1;
            d[at + PackedContacts.IMPULSE_T] *= share;
            d[at + PackedContacts.IMPULSE_R] *= share;
        }
    }

    private void keep(int at) {
        contacts.data[at + PackedContacts.BEFORE0] = contacts.data[at + PackedContacts.IMPULSE0];
        contacts.data[at + PackedContacts.BEFORE1] = contacts.data[at + PackedContacts.IMPULSE1];
    }

    /** Scales the impulses of the kick before, as {@link #apply} scales the present ones. */
    public void scaleBefore(double scale, int substep) {
        for (int row = 0; row < contacts.count; row++) {
            if (contacts.firstSubstep[row] <= substep) {
                contacts.data[row * PackedContacts.STRIDE + PackedContacts.BEFORE0] *= scale;
                contacts.data[row * PackedContacts.STRIDE + PackedContacts.BEFORE1] *= scale;
            }
        }
    }

    /** Scales every impulse and applies it to the bodies. */
    public void apply(double scale, int substep) {
        for (int row = 0; row < contacts.count; row++) {
            if (contacts.firstSubstep[row] <= substep) {
                contacts.scaleImpulses(row, scale);
            }
        }
        add(1, substep);
    }

    /**
     * Takes impulses back as far as they drive bodies apart, in a number of passes: the load that a
     * contact carried before may be gone. No impulse grows.
     */
    public void takeBackWhatParts(int substep, int passes) {
        for (int pass = 0; pass < passes; pass++) {
            for (int row = 0; row < contacts.count; row++) {
                if (contacts.firstSubstep[row] <= substep) {
                    takeBackWhatParts(row);
                }
            }
        }
    }

    private void takeBackWhatParts(int row) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        double j0 = d[at + PackedContacts.IMPULSE0];
        double j1 = d[at + PackedContacts.IMPULSE1];
        double both = j0 + j1;
        if (!(both > 0)) {
            return;
        }
        double parts0 = motions.parting(contacts, row, 0);
        double less0 = kept(j0, parts0, d[at + PackedContacts.K00]);
        double parts1 =
                j1 > 0
                        ? motions.parting(contacts, row, 1)
                                + d[at + PackedContacts.K01] * (less0 - j0)
                        : 0;
        double less1 = kept(j1, parts1, d[at + PackedContacts.K11]);
        double share = (less0 + less1) / both;
        if (share < 1) {
            addOf(row, -1);
            d[at + PackedContacts.IMPULSE0] = less0;
            d[at + PackedContacts.IMPULSE1] = less1;
            d[at + PackedContacts.IMPULSE_T] *= share;
            d[at + PackedContacts.IMPULSE_R] *= share;
            addOf(row, 1);
        }
    }

    /** An impulse in N·s, less what lets its point part at a speed in m/s; at least 0. */
    private static double kept(double impulse, double parts, double response) {
        return parts > 0 && impulse > 0 ? Math.max(0, impulse - parts / response) : impulse;
    }

    /** Applies a multiple of all impulses to the bodies; −1 takes them back. */
    public void add(double multiple, int substep) {
        for (int row = 0; row < contacts.count; row++) {
            if (contacts.firstSubstep[row] <= substep) {
                addOf(row, multiple);
            }
        }
    }

    private void addOf(int row, double multiple) {
        double[] d = contacts.data;
        double[] m = motions.data;
        int at = row * PackedContacts.STRIDE;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double nx = d[at + PackedContacts.NX];
        double ny = d[at + PackedContacts.NY];
        double j0 = multiple * d[at + PackedContacts.IMPULSE0];
        double j1 = multiple * d[at + PackedContacts.IMPULSE1];
        double jt = multiple * d[at + PackedContacts.IMPULSE_T];
        double jx = (j0 + j1) * nx - jt * ny;
        double jy = (j0 + j1) * ny + jt * nx;
        m[a + VX] -= m[a + INVERSE_MASS] * jx;
        m[a + VY] -= m[a + INVERSE_MASS] * jy;
        m[b + VX] += m[b + INVERSE_MASS] * jx;
        m[b + VY] += m[b + INVERSE_MASS] * jy;
        if (motions.turns) {
            turn(m, d, at, a, b, j0, j1, jt, multiple * d[at + PackedContacts.IMPULSE_R]);
        }
    }

    private static void turn(
            double[] m,
            double[] d,
            int at,
            int a,
            int b,
            double j0,
            double j1,
            double jt,
            double jr) {
        double onA =
                j0 * d[at + PackedContacts.LEVER_A0]
                        + j1 * d[at + PackedContacts.LEVER_A1]
                        + jt * d[at + PackedContacts.LEVER_TA]
                        + jr;
        double onB =
                j0 * d[at + PackedContacts.LEVER_B0]
                        + j1 * d[at + PackedContacts.LEVER_B1]
                        + jt * d[at + PackedContacts.LEVER_TB]
                        + jr;
        m[a + SPIN] -= m[a + INVERSE_INERTIA] * onA;
        m[b + SPIN] += m[b + INVERSE_INERTIA] * onB;
    }
}
