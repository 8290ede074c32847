package rigibo.backend.contact.solve;

import rigibo.backend.algebra.EnvelopeFactor;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

import java.util.Arrays;

/**
 * The matrix K = J·M⁻¹·Jᵀ of a set of single rows, with their compliances on its diagonal, factored
 * as L·U within its envelope, which in a stack is a band of six rows. If contacts slide, their
 * loads cause friction too, and K + s·μ·J·M⁻¹·Tᵀ is not symmetric. If none slides, U = D·Lᵀ takes
 * half the work.
 */
final class RowFactor {

    /** Work of solving a row of a set besides factoring, in multiplications. */
    private static final int WORK_OF_ROW = 60;

    /** Work of writing a non-zero entry of the matrix, in multiplications. */
    private static final int WORK_OF_ENTRY = 10;

    private final PackedContacts contacts;
    private final FlatRows rows;
    private final ContactOrder order;

    /** The factored set, in the order of contacts. */
    private int[] factored = new int[64];

    /** By row of the factored set: s·μ of a sliding contact's normal, otherwise 0. */
    private double[] sliding = new double[64];

    private boolean isSymmetric = true;
    private int size;

    private final EnvelopeFactor factor = new EnvelopeFactor();

    /** By place in the order: the first row of the set from there on. */
    private int[] firstInSet = new int[65];

    /** Multiplications made besides those of factoring. */
    private double work;

    RowFactor(PackedContacts contacts, FlatRows rows, ContactOrder order) {
        this.contacts = contacts;
        this.rows = rows;
        this.order = order;
    }

    /** Multiplications made since the last call. */
    double work() {
        return work + factor.work();
    }

    void clearWork() {
        work = 0;
        factor.clearWork();
    }

    /**
     * Estimated multiplications of factoring, from the envelope of all rows and the share of them
     * that may be loaded.
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
        factor.lay(0);
    }

    /** Number of factored rows; 0 without a factor. */
    int size() {
        return size;
    }

    /** Whether no contact of the factored set slides. */
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

    /** Factors the matrix of a set, from the first row on that differs from the last set. */
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
            // Of a redundant row only its compliance is left on the diagonal.
            factor.eliminate(i, isSymmetric, rows.give[factored[i]]);
        }
    }

    private boolean isFactored(int i, int k) {
        return factored[i] == k && sliding[i] == rows.slides(k);
    }

    /** Finds by place in the order where its rows begin in the set. */
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

    /** Lays out the envelope: a row's begins at the first row that may share a body with it. */
    private void layEnvelope() {
        for (int i = 0; i < size; i++) {
            factor.first[i] = firstInSet[order.firstNeighbour[factored[i] / FlatRows.KINDS]];
        }
        factor.lay(size);
    }

    /** Writes the responses between a row and those before it that share a body with it. */
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
     * Solves for the changes of impulse that give the rows of a set the speeds they aim at, N·s.
     */
    void solveSet(int[] set, int count, double[] change) {
        factorize(set, count);
        work += WORK_OF_ROW * count;
        for (int i = 0; i < count; i++) {
            change[i] = -rows.approach(set[i]);
        }
        solve(change);
    }

    /** Solves the factored set for a right-hand side, in place. */
    void solve(double[] unknown) {
        factor.solve(unknown);
    }
}
