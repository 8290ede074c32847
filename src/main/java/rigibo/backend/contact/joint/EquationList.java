package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * The rows of an island that are equations, numbered, and which bodies are in which of them. Only
 * bodies that impulses move count. Rows of a joint with bounds, one after the other, share the
 * place of one equation, which stands for one of them or for none: so what holds may change without
 * another order of elimination.
 */
final class EquationList {

    static final int NONE = -1;

    private final Motions motions;
    private final NeutralRows rows;

    /** How many equations there are, and how many bodies. */
    int count;

    int bodyCount;

    /** By equation its row, or {@link #NONE} where none of its rows holds. */
    int[] row = new int[64];

    /** By equation the first of its rows and how many they are; 0 where it always holds. */
    int[] firstBounded = new int[64];

    int[] boundedCount = new int[64];

    /** By body its entry of the motions. */
    int[] entry = new int[16];

    /** By equation where its bodies start, the bodies, and which of its row's bodies each is. */
    private int[] bodyStart = new int[65];

    private int[] body = new int[128];

    /** By body where its equations start, and the equations. */
    private int[] equationStart = new int[18];

    private int[] equation = new int[128];

    /** By entry of the motions its body. */
    private int[] bodyOfEntry = new int[16];

    /** What the list was made of last: by derivative the offset of its body. */
    private int[] before = new int[256];

    private int beforeBodies;

    EquationList(Motions motions, NeutralRows rows) {
        this.motions = motions;
        this.rows = rows;
    }

    /**
     * Lists the equations of the rows as they are now, of bounded rows none; whether they are of
     * other bodies than before.
     */
    boolean list() {
        boolean isOther = reserve() | beforeBodies != motions.count;
        int countBefore = count;
        count = 0;
        for (int i = 0; i < rows.count; i++) {
            if (rows.isEquation(i)) {
                isOther |= add(i);
                row[count - 1] = i;
                boundedCount[count - 1] = 0;
            } else if (mayHold(i)) {
                if (!isOfLast(i)) {
                    isOther |= add(i);
                    row[count - 1] = NONE;
                    firstBounded[count - 1] = i;
                    boundedCount[count - 1] = 0;
                }
                boundedCount[count - 1]++;
            }
        }
        isOther |= count != countBefore;
        beforeBodies = motions.count;
        if (isOther) {
            link();
        }
        return isOther;
    }

    private boolean add(int i) {
        boolean isOther = false;
        int at = NeutralRows.BODIES * count++;
        for (int k = 0; k < NeutralRows.BODIES; k++) {
            int offset = k < rows.bodies[i] ? rows.body[i * NeutralRows.BODIES + k] : 0;
            int kept = isMoved(offset) ? offset : 0;
            isOther |= before[at + k] != kept;
            before[at + k] = kept;
        }
        return isOther;
    }

    /** Whether a row with bounds may be within them for long. */
    private boolean mayHold(int i) {
        return rows.lower[i] < rows.upper[i]
                && rows.twin[i] == NeutralRows.NONE
                && rows.load[i] == NeutralRows.NONE;
    }

    /** Whether a row with bounds goes with those before it. */
    private boolean isOfLast(int i) {
        int last = count - 1;
        return last >= 0
                && boundedCount[last] > 0
                && firstBounded[last] + boundedCount[last] == i
                && rows.joint[firstBounded[last]] == rows.joint[i];
    }

    private boolean isMoved(int offset) {
        return motions.data[offset + Motions.INVERSE_MASS] > 0
                || motions.data[offset + Motions.INVERSE_INERTIA] > 0;
    }

    /** Makes room; whether what was listed before is lost by that. */
    private boolean reserve() {
        int rowCount = rows.bodies.length;
        boolean isAny = row.length < rowCount || entry.length < motions.count;
        if (row.length < rowCount) {
            row = new int[rowCount];
            firstBounded = new int[rowCount];
            boundedCount = new int[rowCount];
            bodyStart = new int[rowCount + 1];
            body = new int[rowCount * NeutralRows.BODIES];
            equation = new int[rowCount * NeutralRows.BODIES];
            before = new int[rowCount * NeutralRows.BODIES];
        }
        if (entry.length < motions.count) {
            entry = new int[motions.slots.length];
            bodyOfEntry = new int[motions.slots.length];
            equationStart = new int[motions.slots.length + 2];
        }
        return isAny;
    }

    private void link() {
        Arrays.fill(bodyOfEntry, 0, motions.count, NONE);
        bodyCount = 0;
        int at = 0;
        for (int e = 0; e < count; e++) {
            bodyStart[e] = at;
            for (int k = 0; k < NeutralRows.BODIES; k++) {
                int offset = before[e * NeutralRows.BODIES + k];
                int of = offset / Motions.STRIDE;
                if (offset != 0) {
                    if (bodyOfEntry[of] == NONE) {
                        bodyOfEntry[of] = bodyCount;
                        entry[bodyCount++] = of;
                    }
                    if (!isListed(bodyStart[e], at, bodyOfEntry[of])) {
                        body[at++] = bodyOfEntry[of];
                    }
                }
            }
        }
        bodyStart[count] = at;
        linkBodies(at);
    }

    private boolean isListed(int from, int to, int wanted) {
        for (int i = from; i < to; i++) {
            if (body[i] == wanted) {
                return true;
            }
        }
        return false;
    }

    /** Counting sort of equations by body. */
    private void linkBodies(int length) {
        Arrays.fill(equationStart, 0, bodyCount + 2, 0);
        for (int i = 0; i < length; i++) {
            equationStart[body[i] + 2]++;
        }
        for (int i = 1; i <= bodyCount; i++) {
            equationStart[i + 1] += equationStart[i];
        }
        for (int e = 0; e < count; e++) {
            for (int k = bodyStart[e]; k < bodyStart[e + 1]; k++) {
                equation[equationStart[body[k] + 1]++] = e;
            }
        }
    }

    /** The body of an entry of the motions, or {@link #NONE}: it is in no equation. */
    int bodyOfEntry(int of) {
        return bodyOfEntry[of];
    }

    int bodyStart(int e) {
        return bodyStart[e];
    }

    int bodyEnd(int e) {
        return bodyStart[e + 1];
    }

    /** A body of an equation, at a place between its start and its end. */
    int bodyOf(int place) {
        return body[place];
    }

    int equationStart(int of) {
        return equationStart[of];
    }

    int equationEnd(int of) {
        return equationStart[of + 1];
    }

    /** An equation of a body, at a place between its start and its end. */
    int equationOf(int place) {
        return equation[place];
    }
}
