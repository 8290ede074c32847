package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * The equations of an island, numbered, and the bodies of each. Only bodies that impulses can move
 * are listed. Successive rows with bounds of one joint share an equation, which stands for one of
 * them or for none. So the set of rows that hold may change without a new order of elimination.
 *
 * <p>A body of very many equations would couple them all, and its part of the factor would grow
 * with the square of their number. So it is listed as several copies, each with its share of the
 * mass and of the equations. Three equations without rows weld each copy to the next.
 */
final class EquationList {

    static final int NONE = -1;

    /** Most equations of one copy of a body, besides those that weld it to others. */
    static final int MOST_OF_COPY = 24;

    private static final int WELDS = 3;

    private final Motions motions;
    private final NeutralRows rows;

    /** Number of equations, including those that weld copies, and number of bodies. */
    int count;

    int all;

    int bodyCount;

    /**
     * By equation: its row, or {@link #NONE} if none of its rows holds. Arrays by equation are
     * sized with the first list, by the capacity of the rows.
     */
    int[] row = {};

    /** By equation: its first row and the number of its rows; 0 if it always holds. */
    int[] firstBounded = {};

    int[] boundedCount = {};

    /** By body: its entry of the motions, the number of that body's copies, and the next copy. */
    int[] entry = new int[16];

    private int[] copies = new int[16];
    private int[] nextCopy = new int[16];

    /** By copy: its number of equations. */
    private int[] taken = new int[16];

    /**
     * By equation: the start of its bodies; the bodies; and for each its number among the row's
     * bodies.
     */
    private int[] bodyStart = {};

    private int[] body = {};

    /** By body: the start of its equations; and the equations. */
    private int[] equationStart = new int[18];

    private int[] equation = {};

    /** By entry of the motions: its body, and the last copy of it. */
    private int[] bodyOfEntry = new int[16];

    private int[] lastCopy = new int[16];

    /** The last list, for comparison: by derivative the offset of its body. */
    private int[] before = {};

    private int beforeBodies;

    EquationList(Motions motions, NeutralRows rows) {
        this.motions = motions;
        this.rows = rows;
    }

    /**
     * Lists the equations of the present rows, without those with bounds; returns whether their
     * bodies differ from the last list's.
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

    /** Whether a row with bounds may stay within them for long. */
    private boolean mayHold(int i) {
        return rows.lower[i] < rows.upper[i]
                && rows.twin[i] == NeutralRows.NONE
                && rows.load[i] == NeutralRows.NONE;
    }

    /** Whether a row with bounds shares its equation with the row before it. */
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

    /** Grows arrays if needed; returns whether the last list is lost by that. */
    private boolean reserve() {
        int rowCount = rows.bodies.length;
        int most = motions.count + mostCopies(rowCount);
        boolean areRowsShort = row.length < rowCount;
        // More rows of any kind allow for more copies, even if the equations stay the same.
        boolean areBodiesShort = entry.length < most;
        if (areRowsShort) {
            int welds = WELDS * mostCopies(rowCount);
            row = new int[rowCount + welds];
            firstBounded = new int[rowCount + welds];
            boundedCount = new int[rowCount + welds];
            bodyStart = new int[rowCount + welds + 1];
            body = new int[rowCount * NeutralRows.BODIES + 2 * welds];
            equation = new int[rowCount * NeutralRows.BODIES + 2 * welds];
            before = new int[rowCount * NeutralRows.BODIES];
        }
        if (areBodiesShort) {
            int capacity = motions.slots.length + mostCopies(rowCount);
            entry = new int[capacity];
            copies = new int[capacity];
            nextCopy = new int[capacity];
            taken = new int[capacity];
            bodyOfEntry = new int[capacity];
            lastCopy = new int[capacity];
            equationStart = new int[capacity + 2];
        }
        return areRowsShort || areBodiesShort;
    }

    /** Upper bound on the number of copies. */
    private static int mostCopies(int rowCount) {
        return rowCount * NeutralRows.BODIES / MOST_OF_COPY;
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
                        lastCopy[of] = addBody(of);
                    }
                    if (!isListed(bodyStart[e], at, lastCopy[of])) {
                        body[at++] = copyOf(of);
                    }
                }
            }
        }
        bodyStart[count] = at;
        linkBodies(weld(at));
    }

    private int addBody(int of) {
        int added = bodyCount++;
        entry[added] = of;
        nextCopy[added] = NONE;
        taken[added] = 0;
        copies[bodyOfEntry[of]] = added == bodyOfEntry[of] ? 1 : copies[bodyOfEntry[of]] + 1;
        return added;
    }

    /** The copy of a body that takes the next equation. */
    private int copyOf(int of) {
        if (taken[lastCopy[of]] == MOST_OF_COPY) {
            int next = addBody(of);
            nextCopy[lastCopy[of]] = next;
            lastCopy[of] = next;
        }
        taken[lastCopy[of]]++;
        return lastCopy[of];
    }

    /** Adds equations that weld copies to each other; returns where their bodies end. */
    private int weld(int from) {
        int at = from;
        all = count;
        for (int i = 0; i < bodyCount; i++) {
            for (int k = 0; k < WELDS && nextCopy[i] != NONE; k++) {
                row[all] = NONE;
                boundedCount[all] = 0;
                bodyStart[all++] = at;
                body[at++] = i;
                body[at++] = nextCopy[i];
            }
        }
        bodyStart[all] = at;
        return at;
    }

    /** Whether an equation welds two copies of a body. */
    boolean isWeld(int e) {
        return e >= count;
    }

    /** Coordinate that an equation welds: 0 for x, 1 for y, 2 for the angle. */
    int weldedAlong(int e) {
        return (e - count) % WELDS;
    }

    /** Number of copies of the body that this is a copy of. */
    int copiesOf(int of) {
        return copies[bodyOfEntry[entry[of]]];
    }

    /** The next copy of a body after this one, or {@link #NONE}. */
    int nextCopy(int of) {
        return nextCopy[of];
    }

    /** Whether a body is the first of its copies. */
    boolean isFirst(int of) {
        return bodyOfEntry[entry[of]] == of;
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
        for (int e = 0; e < all; e++) {
            for (int k = bodyStart[e]; k < bodyStart[e + 1]; k++) {
                equation[equationStart[body[k] + 1]++] = e;
            }
        }
    }

    /** The body of an entry of the motions, or {@link #NONE} if it is in no equation. */
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
