package rigibo.backend.contact.joint;

import rigibo.backend.storage.JointStore;

import java.util.Arrays;

/** States of rows that only push (stops: limits, ropes, contact points) in a part of a substep. */
final class RowStates {

    /** Within its bounds, like any other row. */
    static final byte BOUND = 0;

    /** Away from its stop: it does not push, and is watched for when it closes. */
    static final byte OPEN = 1;

    /** Pressed on its stop: an equation for the whole part. */
    static final byte HELD = 2;

    private static final int POINTS = 2;

    private byte[] ofJoints = new byte[16 * JointStore.ROWS];
    private byte[] ofContacts = new byte[16 * POINTS];

    /** Whether any row is in another state than bound. */
    boolean areAny;

    /** Marks all rows of a number of joints and contacts as bound. */
    void clear(int joints, int contacts) {
        if (ofJoints.length < joints * JointStore.ROWS) {
            ofJoints = new byte[2 * joints * JointStore.ROWS];
        }
        if (ofContacts.length < contacts * POINTS) {
            ofContacts = new byte[2 * contacts * POINTS];
        }
        Arrays.fill(ofJoints, 0, joints * JointStore.ROWS, BOUND);
        Arrays.fill(ofContacts, 0, contacts * POINTS, BOUND);
        areAny = false;
    }

    byte ofJoint(int joint, int part) {
        return ofJoints[joint * JointStore.ROWS + part];
    }

    byte ofContact(int contact, int point) {
        return ofContacts[contact * POINTS + point];
    }

    void setJoint(int joint, int part, byte state) {
        ofJoints[joint * JointStore.ROWS + part] = state;
        areAny |= state != BOUND;
    }

    void setContact(int contact, int point, byte state) {
        ofContacts[contact * POINTS + point] = state;
        areAny |= state != BOUND;
    }
}
