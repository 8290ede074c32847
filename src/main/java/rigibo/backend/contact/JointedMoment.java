package rigibo.backend.contact;

import rigibo.backend.contact.joint.JointSolver;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Pairs;

/**
 * A saved state of an island with joints, to be restored later: the motion of bodies and the
 * impulses of contacts and joints. Restoring does not undo later measurements of contacts, since
 * the newest is the most accurate. A point that did not exist in the saved state gets no impulse,
 * and the impulse of a point that no longer exists is dropped, since no row could take it back.
 */
final class JointedMoment {

    /** Columns that are saved of a contact, first the impulses of its points in order. */
    private static final int[] KEPT = {
        PackedContacts.IMPULSE0,
        PackedContacts.IMPULSE1,
        PackedContacts.IMPULSE_T,
        PackedContacts.IMPULSE_R,
        PackedContacts.TOTAL,
    };

    private final Motions motions;
    private final PackedContacts contacts;
    private final Pairs pairs;
    private final JointSolver joints;
    private double[] bodies = new double[16 * Motions.STRIDE];
    private double[] impulses = new double[16 * KEPT.length];

    /** By contact: its number of points. */
    private int[] points = new int[16];

    /** By point: its feature id. */
    private int[] features = new int[32];

    JointedMoment(Motions motions, PackedContacts contacts, Pairs pairs, JointSolver joints) {
        this.motions = motions;
        this.contacts = contacts;
        this.pairs = pairs;
        this.joints = joints;
    }

    void keep() {
        if (bodies.length < motions.count * Motions.STRIDE) {
            bodies = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, bodies, 0, motions.count * Motions.STRIDE);
        if (impulses.length < contacts.count * KEPT.length) {
            impulses = new double[contacts.pair.length * KEPT.length];
            points = new int[contacts.pair.length];
            features = new int[2 * contacts.pair.length];
        }
        for (int row = 0; row < contacts.count; row++) {
            points[row] = contacts.points[row];
            features[2 * row] = pairs.feature[2 * contacts.pair[row]];
            features[2 * row + 1] = pairs.feature[2 * contacts.pair[row] + 1];
            for (int i = 0; i < KEPT.length; i++) {
                impulses[row * KEPT.length + i] =
                        contacts.data[row * PackedContacts.STRIDE + KEPT[i]];
            }
        }
        joints.keep();
    }

    void recall() {
        System.arraycopy(bodies, 0, motions.data, 0, motions.count * Motions.STRIDE);
        for (int row = 0; row < contacts.count; row++) {
            for (int i = 0; i < KEPT.length; i++) {
                contacts.data[row * PackedContacts.STRIDE + KEPT[i]] =
                        impulses[row * KEPT.length + i];
            }
            if (contacts.points[row] != points[row]) {
                handOn(row);
            }
        }
        joints.recall();
    }

    /** Gives each point the saved impulse of the point with the same feature id. */
    private void handOn(int row) {
        int at = row * PackedContacts.STRIDE;
        for (int point = 0; point < 2; point++) {
            int feature = pairs.feature[2 * contacts.pair[row] + point];
            boolean isThere = point < contacts.points[row];
            contacts.data[at + KEPT[point]] = isThere ? carried(row, feature) : 0;
        }
    }

    private double carried(int row, int feature) {
        for (int point = 0; point < points[row]; point++) {
            if (features[2 * row + point] == feature) {
                return impulses[row * KEPT.length + point];
            }
        }
        return 0;
    }
}
