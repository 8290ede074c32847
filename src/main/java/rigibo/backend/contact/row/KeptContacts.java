package rigibo.backend.contact.row;

import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Hits;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.Pairs;

/**
 * The contacts of an island as its step begins, to be restored before the step is made again.
 * Within a step, contacts are measured where their bodies are by then, and impacts are noted.
 */
public final class KeptContacts {

    /** Numbers, whole numbers and marks that are kept of a pair. */
    private static final int NUMBERS = 14;

    private static final int WHOLES = 8;
    private static final int MARKS = 2;

    private final Pairs pairs;
    private final Islands islands;
    private final Hits hits;
    private final PackedContacts contacts;

    private double[] numbers = new double[16 * NUMBERS];
    private int[] wholes = new int[16 * WHOLES];
    private boolean[] marks = new boolean[16 * MARKS];

    /** Number of hits of the step, and of impacts, before the island's. */
    private int hitCount;

    private int impactCount;

    /** Whether values are restored at present, not kept; and the next of them. */
    private boolean isRestoring;

    private int nextNumber;
    private int nextWhole;

    public KeptContacts(DataStorage data, PackedContacts contacts) {
        pairs = data.pairs;
        islands = data.islands;
        hits = data.noteHits();
        this.contacts = contacts;
    }

    /** Keeps the contacts of an island. */
    public void keep(int island) {
        int count = islands.pairStart[island + 1] - islands.pairStart[island];
        if (marks.length < count * MARKS) {
            int room = 2 * count;
            numbers = new double[room * NUMBERS];
            wholes = new int[room * WHOLES];
            marks = new boolean[room * MARKS];
        }
        hitCount = hits.count;
        impactCount = contacts.work.impacts;
        for (int i = 0; i < count; i++) {
            int pair = islands.pairs[islands.pairStart[island] + i];
            marks[MARKS * i] = hits.isForetold(pair);
            marks[MARKS * i + 1] = hits.isExpected(pair);
        }
        pass(island, false);
    }

    /** Restores the contacts of the island that was kept last, and forgets its impacts. */
    public void restore(int island) {
        hits.count = hitCount;
        contacts.work.impacts = impactCount;
        int first = islands.pairStart[island];
        for (int i = first; i < islands.pairStart[island + 1]; i++) {
            int at = MARKS * (i - first);
            hits.markAgain(islands.pairs[i], marks[at], marks[at + 1]);
        }
        pass(island, true);
    }

    private void pass(int island, boolean restores) {
        isRestoring = restores;
        nextNumber = 0;
        nextWhole = 0;
        for (int i = islands.pairStart[island]; i < islands.pairStart[island + 1]; i++) {
            passPair(islands.pairs[i]);
        }
    }

    private void passPair(int pair) {
        pass(pairs.normalX, pair);
        pass(pairs.normalY, pair);
        pass(pairs.middleX, pair);
        pass(pairs.middleY, pair);
        pass(pairs.reach, pair);
        pass(pairs.faceOf, pair);
        pass(pairs.points, pair);
        pass(pairs.impacts, pair);
        if (pairs.passage != null) {
            pass(pairs.passage, pair);
            pass(pairs.beside, pair);
        }
        for (int point = 2 * pair; point < 2 * pair + 2; point++) {
            pass(pairs.pointX, point);
            pass(pairs.pointY, point);
            pass(pairs.separation, point);
            pass(pairs.normalForce, point);
            pass(pairs.feature, point);
            pass(pairs.former, point);
        }
    }

    private void pass(double[] column, int at) {
        if (isRestoring) {
            column[at] = numbers[nextNumber++];
        } else {
            numbers[nextNumber++] = column[at];
        }
    }

    private void pass(int[] column, int at) {
        if (isRestoring) {
            column[at] = wholes[nextWhole++];
        } else {
            wholes[nextWhole++] = column[at];
        }
    }
}
