package rigibo.backend.storage;

import java.util.Arrays;

/**
 * The islands of this step: groups of piled bodies that touch each other, and their pairs. Island i
 * holds {@code bodies[bodyStart[i] .. bodyStart[i + 1]]} and {@code pairs[pairStart[i] .. ]}.
 */
public final class Islands {

    public int count;
    public int[] bodyStart = new int[17];
    public int[] pairStart = new int[17];

    /** By island, while the lists are filled: index for its next body, and for its next pair. */
    public int[] bodyFill = new int[17];

    public int[] pairFill = new int[17];
    public int[] bodies = new int[16];
    public int[] pairs = new int[16];

    /**
     * The joints of island i: {@code joints[jointStart[i] .. jointStart[i + 1]]}; null where none
     * are declared.
     */
    public int[] jointStart;

    public int[] joints;

    /** Whether an island has joints. */
    public boolean areJoined(int island) {
        return jointStart != null && jointStart[island + 1] > jointStart[island];
    }

    /** Makes room for the joints of a number of islands. */
    public void reserveJoints(int islands, int jointCount) {
        if (jointStart == null || jointStart.length <= islands + 1) {
            jointStart = new int[2 * (islands + 2)];
        }
        if (joints == null || joints.length < jointCount) {
            joints = new int[2 * jointCount + 1];
        }
        Arrays.fill(jointStart, 0, islands + 2, 0);
    }

    /** Makes room for a number of islands, bodies and pairs; present contents may be lost. */
    public void reserve(int islands, int bodyCount, int pairCount) {
        if (bodyStart.length <= islands) {
            bodyStart = new int[Math.max(islands + 1, 2 * bodyStart.length)];
            pairStart = new int[bodyStart.length];
            bodyFill = new int[bodyStart.length];
            pairFill = new int[bodyStart.length];
        }
        if (bodies.length < bodyCount) {
            bodies = new int[Math.max(bodyCount, 2 * bodies.length)];
        }
        if (pairs.length < pairCount) {
            pairs = new int[Math.max(pairCount, 2 * pairs.length)];
        }
        Arrays.fill(bodyStart, 0, islands + 1, 0);
        Arrays.fill(pairStart, 0, islands + 1, 0);
    }

    /** Starts to fill the lists of every island from their beginnings. */
    public void rewind() {
        System.arraycopy(bodyStart, 0, bodyFill, 0, count);
        System.arraycopy(pairStart, 0, pairFill, 0, count);
    }
}
