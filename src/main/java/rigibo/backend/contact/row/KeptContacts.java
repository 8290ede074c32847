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

    /** Numbers and whole numbers that are kept of a pair. */
    private static final int NUMBERS = 14;

    private static final int WHOLES = 9;

    private final Pairs pairs;
    private final Islands islands;
    private final Hits hits;
    private final PackedContacts contacts;

    private double[] numbers = new double[16 * NUMBERS];
    private int[] wholes = new int[16 * WHOLES];

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
        if (wholes.length < count * WHOLES) {
            numbers = new double[2 * count * NUMBERS];
            wholes = new int[2 * count * WHOLES];
        }
        hitCount = hits.count;
        impactCount = contacts.work.impacts;
        pass(island, false);
    }

    /** Restores the contacts of the island that was kept last, and forgets its impacts. */
    public void restore(int island) {
        hits.count = hitCount;
        contacts.work.impacts = impactCount;
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
        passMarks(pair);
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

    private void passMarks(int pair) {
        if (isRestoring) {
            hits.markAgain(pair, wholes[nextWhole++]);
        } else {
            wholes[nextWhole++] = hits.marks(pair);
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
