package rigibo.backend.contact.solve;

import rigibo.backend.algebra.EnvelopeFactor;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.SingleRows;

import java.util.Arrays;

/**
 * The matrix K = J·M⁻¹·Jᵀ of a set of single rows, with what they give way on its diagonal,
 * factored as L·U within its envelope: in a stack a band of six rows. Where contacts slide, what
 * presses them also rubs, and K + s·μ·J·M⁻¹·Tᵀ is not symmetric; where none does, U = D·Lᵀ takes
 * half the work.
 */
final class RowFactor {

    /** Room for any small island in motion: none grows once the first is solved. */
    private static final int FULL =
            SingleRows.MOST_ELIMINATED * (SingleRows.MOST_ELIMINATED + 1) / 2;

    /** Multiplications that a row takes when its set is solved, beside those of factoring. */
    private static final int WORK_OF_ROW = 60;

    /** Multiplications that writing one entry of the matrix takes that is not 0. */
    private static final int WORK_OF_ENTRY = 10;

    private final PackedContacts contacts;
    private final FlatRows rows;
    private final ContactOrder order;

    /** The set that is factored, in the order of contacts, and s·μ of each of its normals. */
    private int[] factored = new int[64];

    private double[] sliding = new double[64];
    private boolean isSymmetric = true;
    private int size;

    private final EnvelopeFactor factor = new EnvelopeFactor();

    /** For each place in the order the first row of the set from there on. */
    private int[] firstInSet = new int[65];

    /** Multiplications made beside those of factoring. */
    private double work;

    RowFactor(PackedContacts contacts, FlatRows rows, ContactOrder order) {
        this.contacts = contacts;
        this.rows = rows;
        this.order = order;
    }

    /** Multiplications made since they were counted last. */
    double work() {
        return work + factor.work();
    }

    void clearWork() {
        work = 0;
        factor.clearWork();
    }

    /**
     * Multiplications that factoring takes, by the envelope of all rows and the share of them that
     * may be loaded.
     */
    double workOfAll() {
        double all = 0;
        for (int place = 0; place < contacts.count; place++) {
            double width = FlatRows.KINDS * (place - order.firstNeighbour[place] + 1);
            all += FlatRows.KINDS * width * width / 2;
        }
        double loaded = contacts.shareLoaded();
        return loaded * loaded * loaded * all;
    }

    void forget() {
        size = 0;
        factor.lay(0, 0);
    }

    /** How many rows are factored, 0 where nothing is. */
    int size() {
        return size;
    }

    /** Whether no contact was taken to slide. */
    boolean isSymmetric() {
        return isSymmetric;
    }

    /** Writes the factored set and returns its size. */
    int writeSet(int[] to) {
        System.arraycopy(factored, 0, to, 0, size);
        return size;
    }

    private void reserve() {
        if (firstInSet.length <= contacts.count
                || factored.length < FlatRows.KINDS * contacts.count) {
            int capacity = FlatRows.KINDS * contacts.pair.length;
            factored = Arrays.copyOf(factored, capacity);
            sliding = Arrays.copyOf(sliding, capacity);
            factor.reserve(capacity);
            firstInSet = new int[contacts.pair.length + 1];
        }
    }

    /** Factors the matrix of a set, from the first row on that the last factor did not have. */
    void factorize(int[] set, int count) {
        reserve();
        int same = 0;
        while (same < Math.min(size, count) && isFactored(same, set[same])) {
            same++;
        }
        if (same == count && same == size) {
            return;
        }
        isSymmetric = true;
        for (int i = 0; i < count; i++) {
            factored[i] = set[i];
            sliding[i] = rows.slides(set[i]);
            isSymmetric &= sliding[i] == 0;
        }
        size = count;
        findPlaces();
        layEnvelope();
        for (int i = same; i < size; i++) {
            factor.clear(i);
            writeEntries(i);
            // Of a redundant row only what it gives way by is left.
            factor.eliminate(i, isSymmetric, rows.give[factored[i]]);
        }
    }

    private boolean isFactored(int i, int k) {
        return factored[i] == k && sliding[i] == rows.slides(k);
    }

    /** For each place in the order where its rows begin in the set. */
    private void findPlaces() {
        int i = 0;
        for (int place = 0; place < contacts.count; place++) {
            firstInSet[place] = i;
            while (i < size && factored[i] / FlatRows.KINDS == place) {
                i++;
            }
        }
        firstInSet[contacts.count] = size;
    }

    /** A row's envelope begins with the first loaded row of the first contact it shares with. */
    private void layEnvelope() {
        for (int i = 0; i < size; i++) {
            factor.first[i] = firstInSet[order.firstNeighbour[factored[i] / FlatRows.KINDS]];
        }
        factor.lay(size, FULL);
    }

    /** Writes what a row and those before it give each other: those that share a body with it. */
    private void writeEntries(int i) {
        int row = order.order[factored[i] / FlatRows.KINDS];
        writeEntries(i, contacts.bodyA[row]);
        writeEntries(i, contacts.bodyB[row]);
        int k = factored[i];
        factor.writeLower(i, i, rows.answerTo(k, k) + rows.give[k]);
    }

    private void writeEntries(int i, int body) {
        if (body == 0) {
            return;
        }
        int entry = body / Motions.STRIDE;
        for (int at = order.start[entry]; at < order.start[entry + 1]; at++) {
            int place = order.place[order.ofBodies[at]];
            int end = Math.min(firstInSet[place + 1], i);
            for (int j = firstInSet[place]; j < end; j++) {
                factor.writeLower(i, j, rows.answerTo(factored[i], factored[j]));
                work += WORK_OF_ENTRY;
                if (!isSymmetric) {
                    factor.writeUpper(i, j, rows.answerTo(factored[j], factored[i]));
                    work += WORK_OF_ENTRY;
                }
            }
        }
    }

    /**
     * Finds by what the impulses of a set are to change to give its rows what they ask for, N·s.
     */
    void solveSet(int[] set, int count, double[] change) {
        factorize(set, count);
        work += WORK_OF_ROW * count;
        for (int i = 0; i < count; i++) {
            change[i] = -rows.approach(set[i]);
        }
        solve(change);
    }

    /** Solves the factored set for the right side that is given, in place. */
    void solve(double[] unknown) {
        factor.solve(unknown);
    }
}
