package rigibo.backend.contact;

import rigibo.backend.contact.joint.JointSolver;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

/**
 * A moment of an island with joints, to be gone back to: how bodies move, and what contacts and
 * joints have carried. How contacts were measured stays as it is: the newest is the best.
 */
final class JointedMoment {

    private static final int[] KEPT = {
        PackedContacts.IMPULSE0,
        PackedContacts.IMPULSE1,
        PackedContacts.IMPULSE_T,
        PackedContacts.IMPULSE_R,
        PackedContacts.TOTAL,
    };

    private final Motions motions;
    private final PackedContacts contacts;
    private final JointSolver joints;
    private double[] bodies = new double[16 * Motions.STRIDE];
    private double[] impulses = new double[16 * KEPT.length];

    JointedMoment(Motions motions, PackedContacts contacts, JointSolver joints) {
        this.motions = motions;
        this.contacts = contacts;
        this.joints = joints;
    }

    void keep() {
        if (bodies.length < motions.count * Motions.STRIDE) {
            bodies = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, bodies, 0, motions.count * Motions.STRIDE);
        if (impulses.length < contacts.count * KEPT.length) {
            impulses = new double[contacts.pair.length * KEPT.length];
        }
        for (int row = 0; row < contacts.count; row++) {
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
        }
        joints.recall();
    }
}
