package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * The order in which rows are eliminated: bodies breadth first from one end of the island to the
 * other, each row behind the last of its bodies, so that the factor's envelope stays narrow
 * (Cuthill and McKee 1969). A chain is a band as wide as one joint and its neighbour.
 */
final class RowOrder {

    private static final int NOWHERE = -1;

    private final Motions motions;
    private final NeutralRows rows;

    /** The rows in the order of elimination. */
    int[] order = new int[64];

    /** By entry of the motions: its place. By place: its entry. */
    private int[] place = new int[16];

    private int[] placed = new int[16];

    /** The rows of an entry e: rowsOf[start[e]] to rowsOf[start[e + 1]]. */
    private int[] start = new int[18];

    private int[] rowsOf = new int[64 * NeutralRows.BODIES];

    RowOrder(Motions motions, NeutralRows rows) {
        this.motions = motions;
        this.rows = rows;
    }

    /**
     * The last order, for comparison: by row and place the offset of its body, and the number of
     * both.
     */
    private int[] before = new int[64 * NeutralRows.BODIES];

    private int[] manyBefore = new int[64];
    private int rowsBefore = NOWHERE;
    private int bodiesBefore;

    /** Orders all rows, unless their bodies are those of the last call. */
    void find() {
        boolean isRoomier = before.length < NeutralRows.BODIES * rows.count;
        if (isRoomier) {
            before = new int[NeutralRows.BODIES * rows.bodies.length];
            manyBefore = new int[rows.bodies.length];
        }
        if (isOther() | isRoomier) {
            order();
        }
    }

    private boolean isOther() {
        boolean isOther = rowsBefore != rows.count || bodiesBefore != motions.count;
        for (int row = 0; row < rows.count; row++) {
            int at = row * NeutralRows.BODIES;
            isOther |= manyBefore[row] != rows.bodies[row];
            manyBefore[row] = rows.bodies[row];
            for (int i = at; i < at + rows.bodies[row]; i++) {
                isOther |= before[i] != rows.body[i];
                before[i] = rows.body[i];
            }
        }
        rowsBefore = rows.count;
        bodiesBefore = motions.count;
        return isOther;
    }

    private void order() {
        reserve();
        listRows();
        Arrays.fill(place, 0, motions.count, NOWHERE);
        int from = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            if (place[entry] == NOWHERE) {
                // The body reached last is at an end of the island; from there the levels are
                // narrow.
                int reached = walk(entry, from);
                int end = placed[reached - 1];
                for (int i = from; i < reached; i++) {
                    place[placed[i]] = NOWHERE;
                }
                from = walk(end, from);
            }
        }
        sortRows();
    }

    private void reserve() {
        if (place.length < motions.count) {
            place = new int[motions.slots.length];
            placed = new int[motions.slots.length];
            start = new int[motions.slots.length + 2];
        }
        if (order.length < rows.count) {
            order = new int[rows.bodies.length];
            rowsOf = new int[NeutralRows.BODIES * rows.bodies.length];
        }
    }

    private void listRows() {
        Arrays.fill(start, 0, motions.count + 2, 0);
        for (int row = 0; row < rows.count; row++) {
            for (int i = 0; i < rows.bodies[row]; i++) {
                start[entry(row, i) + 2]++;
            }
        }
        for (int entry = 1; entry <= motions.count; entry++) {
            start[entry + 1] += start[entry];
        }
        for (int row = 0; row < rows.count; row++) {
            for (int i = 0; i < rows.bodies[row]; i++) {
                rowsOf[start[entry(row, i) + 1]++] = row;
            }
        }
    }

    private int entry(int row, int i) {
        return rows.body[row * NeutralRows.BODIES + i] / Motions.STRIDE;
    }

    private int walk(int first, int from) {
        int end = from;
        place[first] = end;
        placed[end++] = first;
        for (int at = from; at < end; at++) {
            for (int k = start[placed[at]]; k < start[placed[at] + 1]; k++) {
                int row = rowsOf[k];
                for (int i = 0; i < rows.bodies[row]; i++) {
                    int next = entry(row, i);
                    if (place[next] == NOWHERE) {
                        place[next] = end;
                        placed[end++] = next;
                    }
                }
            }
        }
        return end;
    }

    /** Counting sort of rows by the last of their bodies; the lists have been used up. */
    private void sortRows() {
        Arrays.fill(start, 0, motions.count + 2, 0);
        for (int row = 0; row < rows.count; row++) {
            start[last(row) + 2]++;
        }
        for (int i = 1; i <= motions.count; i++) {
            start[i + 1] += start[i];
        }
        for (int row = 0; row < rows.count; row++) {
            order[start[last(row) + 1]++] = row;
        }
    }

    private int last(int row) {
        int last = 0;
        for (int i = 0; i < rows.bodies[row]; i++) {
            last = Math.max(last, place[entry(row, i)]);
        }
        return last;
    }
}
