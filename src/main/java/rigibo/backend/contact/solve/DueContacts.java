package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.SPIN;
import static rigibo.backend.contact.row.Motions.VX;
import static rigibo.backend.contact.row.Motions.VY;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.SharedRows;
import rigibo.backend.team.Team;

import java.util.Arrays;

/**
 * Finds which contacts of an island are due for a solution: those whose bodies have changed their
 * speed by more than a threshold since the contact was last solved. Most of a heap is quiet at any
 * time, so passes that follow an impact through it cost little. In a crowd the threshold falls with
 * the overlap of a contact; otherwise the same places would sink in a little in every substep, for
 * seconds. A contact in a crowd that carries nothing and parts is skipped until its bodies may have
 * lost their parting speed.
 */
final class DueContacts {

    /** Neglected change of speed, as a share of the relative speed of the two bodies. */
    private static final double OF_THEIR_OWN = 0.3;

    /**
     * Number of contacts up to which it is neglected, less in larger crowds: what all contacts
     * together neglect adds up from storey to storey. In a heap of 1,500 boxes it kept itself up,
     * and the heap sank into its foot.
     */
    private static final double STOREYS_OF = 512;

    /** Overlap in widths from which on a contact is solved most strictly. */
    private static final double DEEP = 0.005;

    /** Allowed error there, as a share of that elsewhere. */
    private static final double STRICTLY = 0.003;

    /**
     * Change of speed that counts as round-off, as a share of the neglected one. Between bodies
     * that stand side by side without pressing each other, round-off alone would decide whether
     * they close or part, and with that which contacts are solved again.
     */
    private static final double NOISE = 1e-6;

    private final Motions motions;
    private final PackedContacts contacts;
    private final SharedRows shared;

    /** By entry of the motions: sum of its changes of speed so far in this sweep, m/s. */
    double[] changed = new double[16];

    /** By contact: that sum for its two bodies when it was last solved, m/s. */
    double[] seen = new double[16];

    /** By contact: the neglected change of speed, m/s. */
    private double[] uncounted = new double[16];

    /** By contact: change of speed since it was last solved above which it is due, m/s. */
    double[] threshold = new double[16];

    /** By point: speed at which it may close because of its gap, m/s. */
    double[] spare = new double[32];

    /** Whether the packed island has more contacts than elimination takes. */
    private boolean isCrowd;

    /**
     * Parameters of the present sweep: the substep's length in s and its number, the neglected
     * change of speed in widths per second, and its bounds in m/s.
     */
    private double h;

    private int substep;
    private double sharePerSecond;
    private double quiet;
    private double least;

    private final Team.Pieces beginningPieces = this::beginPiece;

    DueContacts(Motions motions, PackedContacts contacts, SharedRows shared) {
        this.motions = motions;
        this.contacts = contacts;
        this.shared = shared;
    }

    /**
     * Stores the speeds that gaps allow; bodies do not move within a sweep, so gaps are constant.
     */
    void begin(double h, int substep, double sharePerSecond, double quiet, double least) {
        if (changed.length < motions.count) {
            changed = new double[motions.slots.length];
        }
        if (seen.length < contacts.count) {
            seen = new double[contacts.pair.length];
            uncounted = new double[contacts.pair.length];
            threshold = new double[contacts.pair.length];
            spare = new double[2 * contacts.pair.length];
        }
        Arrays.fill(changed, 0, motions.count, 0);
        isCrowd = contacts.areCrowd();
        this.h = h;
        this.substep = substep;
        this.sharePerSecond = sharePerSecond;
        this.quiet = quiet;
        this.least = least;
        shared.each(contacts.count, beginningPieces);
    }

    private void beginPiece(int from, int to, int worker) {
        double perSubstep = 1 / h;
        double strictly = isCrowd ? STRICTLY : 1;
        for (int row = from; row < to; row++) {
            boolean isThere = contacts.firstSubstep[row] <= substep;
            seen[row] = isThere ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
            double width = contacts.width(row);
            double deepest = 0;
            double nearing = contacts.data[row * PackedContacts.STRIDE + PackedContacts.NEARING];
            for (int point = 0; point < contacts.points[row]; point++) {
                double gap = motions.gap(contacts, row, point);
                spare[2 * row + point] = (gap > 0 ? gap * perSubstep : 0) - nearing;
                deepest = gap < deepest ? gap : deepest;
            }
            double own = least < quiet ? quietBetween(row) : quiet;
            double counts = Math.min(sharePerSecond * width, own);
            uncounted[row] = counts * Math.max(strictly, 1 + deepest / (DEEP * width));
            threshold[row] = uncounted[row];
            if (isThere && isCrowd) {
                leaveAloneWhatParts(row);
            }
        }
    }

    /**
     * Neglected change of speed of a contact, m/s. It depends on the contact's own bodies:
     * otherwise one body that falls through a heap would make all of the heap inaccurate, which
     * would sink a little everywhere, be pushed apart, let other bodies fall and never come to
     * rest.
     */
    private double quietBetween(int row) {
        double[] m = motions.data;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double speed =
                Math.abs(m[a + VX] - m[b + VX])
                        + Math.abs(m[a + VY] - m[b + VY])
                        + motions.reach[a / Motions.STRIDE] * Math.abs(m[a + SPIN])
                        + motions.reach[b / Motions.STRIDE] * Math.abs(m[b + SPIN]);
        double share = OF_THEIR_OWN * Math.min(1, STOREYS_OF / contacts.count);
        return Math.min(quiet, Math.max(share * speed, least));
    }

    /**
     * Finds whether a contact carries nothing and parts. The change of its bodies' speed bounds
     * that of its points, so that until it reaches the parting speed a solution would change
     * nothing.
     */
    private void leaveAloneWhatParts(int row) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        double carried =
                d[at + PackedContacts.IMPULSE0]
                        + d[at + PackedContacts.IMPULSE1]
                        + Math.abs(d[at + PackedContacts.IMPULSE_T]);
        double mobility =
                motions.data[contacts.bodyA[row] + INVERSE_MASS]
                        + motions.data[contacts.bodyB[row] + INVERSE_MASS];
        double noise = NOISE * uncounted[row];
        if (carried * mobility > noise || d[at + PackedContacts.ROLLING] > 0) {
            return;
        }
        double parts = motions.parting(contacts, row, 0) + spare[2 * row];
        if (contacts.points[row] == 2) {
            double other = motions.parting(contacts, row, 1) + spare[2 * row + 1];
            parts = other < parts ? other : parts;
        }
        if (parts > noise) {
            seen[row] = 0;
            threshold[row] = Math.max(uncounted[row], parts);
        }
    }

    /** Contacts that were measured again are due; any other once its bodies change their speed. */
    void deferAllButNew() {
        for (int row = 0; row < contacts.count; row++) {
            seen[row] = contacts.isNew[row] ? seen[row] : Math.max(seen[row], 0);
        }
    }

    /**
     * The change of its bodies' speed above which a contact that was just solved is due again, m/s.
     *
     * @param carried speed that its load before would give its bodies, m/s
     * @param parts speed at which its points parted before, m/s; 0 if it has to be solved anyway
     */
    double threshold(int row, double carried, double parts) {
        boolean carries = carried > NOISE * uncounted[row];
        boolean isIdle = isCrowd && !carries && parts > uncounted[row];
        return isIdle ? parts : uncounted[row];
    }

    /** Whether a contact would sink in by more than a number of widths in h seconds. */
    boolean isSinking(double h, int substep, double most) {
        boolean isSinking = false;
        for (int row = 0; !isSinking && row < contacts.count; row++) {
            double width = contacts.width(row);
            for (int point = 0; point < contacts.points[row]; point++) {
                double parts = motions.parting(contacts, row, point) + spare[2 * row + point];
                isSinking |= contacts.firstSubstep[row] <= substep && -parts * h > most * width;
            }
        }
        return isSinking;
    }

    /** Hands impulses down where bodies would sink in by more than a number of widths. */
    void handDown(ShockPropagation shock, double most) {
        shock.handDown(substep, spare, changed, most / h);
    }
}
