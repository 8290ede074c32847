package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.SingleRows.ROWS_PER_CONTACT;

import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.SingleRows;

import java.util.Arrays;

/**
 * The matrix K = J·M⁻¹·Jᵀ of a set of single rows, with what they give way on its diagonal,
 * factored by Cholesky within its envelope: in a stack a band of six rows.
 */
final class RowFactor {

    /** Room for any small island in motion: none grows once the first is solved. */
    private static final int FULL =
            SingleRows.MOST_ELIMINATED * (SingleRows.MOST_ELIMINATED + 1) / 2;

    /** Multiplications that writing one entry of the matrix takes. */
    private static final int WORK_OF_ENTRY = 40;

    private final PackedContacts contacts;
    private final SingleRows single;
    private final ContactOrder order;

    /** The set that is factored, in the order of contacts. */
    private int[] factored = new int[64];

    private int size;

    /** Lower triangle by rows, from the first entry of each row on, and where each row starts. */
    private double[] factor = new double[0];

    private int[] start = new int[65];
    private int[] first = new int[64];

    /** For each place in the order the first row of the set from there on; and each row's place. */
    private int[] firstInSet = new int[64];

    private int[] placeInOrder = new int[64];

    private double work;

    RowFactor(PackedContacts contacts, SingleRows single, ContactOrder order) {
        this.contacts = contacts;
        this.single = single;
        this.order = order;
    }

    /** Multiplications made since they were counted last. */
    double work() {
        return work;
    }

    void addWork(int multiplications) {
        work += multiplications;
    }

    void clearWork() {
        work = 0;
    }

    /** Multiplications that factoring takes where all rows are loaded, by their envelope. */
    double workOfAll() {
        double all = 0;
        for (int place = 0; place < contacts.count; place++) {
            double width = ROWS_PER_CONTACT * (place - order.firstNeighbour[place] + 1);
            all += ROWS_PER_CONTACT * width * width / 2;
        }
        return all;
    }

    void forget() {
        size = 0;
    }

    /** How many rows are factored, 0 where nothing is. */
    int size() {
        return size;
    }

    /** Writes the factored set and returns its size. */
    int writeSet(int[] to) {
        System.arraycopy(factored, 0, to, 0, size);
        return size;
    }

    private void reserve() {
        if (firstInSet.length < ROWS_PER_CONTACT * contacts.count) {
            int capacity = ROWS_PER_CONTACT * contacts.pair.length;
            factored = Arrays.copyOf(factored, capacity);
            start = Arrays.copyOf(start, capacity + 1);
            first = Arrays.copyOf(first, capacity);
            firstInSet = new int[capacity];
            placeInOrder = new int[capacity];
        }
    }

    /** Factors the matrix of the set, from the first row on that the last factor did not have. */
    void factorize(int[] set, int count) {
        int same = Arrays.mismatch(set, 0, count, factored, 0, size);
        if (same < 0) {
            return;
        }
        reserve();
        System.arraycopy(set, 0, factored, 0, count);
        size = count;
        findPlaces();
        layEnvelope();
        for (int i = same; i < size; i++) {
            for (int j = first[i]; j <= i; j++) {
                double sum = single.response(factored[i], factored[j]);
                if (i == j) {
                    sum += single.give(factored[i]);
                }
                int from = Math.max(first[i], first[j]);
                work += WORK_OF_ENTRY + j - from;
                for (int k = from; k < j; k++) {
                    sum -= factor[start[i] + k - first[i]] * factor[start[j] + k - first[j]];
                }
                factor[start[i] + j - first[i]] =
                        i == j ? root(sum, factored[i]) : sum / factor[start[j] + j - first[j]];
            }
        }
    }

    /** The root of what is left on the diagonal; of a redundant row only its compliance is left. */
    private double root(double remainder, int id) {
        return Math.sqrt(Math.max(remainder, single.give(id)));
    }

    /** Where the rows of the set stand in the order of contacts, and the other way round. */
    private void findPlaces() {
        int i = 0;
        for (int place = 0; place < contacts.count; place++) {
            firstInSet[place] = i;
            while (i < size && factored[i] / ROWS_PER_CONTACT == order.order[place]) {
                placeInOrder[i++] = place;
            }
        }
    }

    /** A row's envelope begins with the first loaded row of the first contact it shares with. */
    private void layEnvelope() {
        int length = 0;
        for (int i = 0; i < size; i++) {
            first[i] = firstInSet[order.firstNeighbour[placeInOrder[i]]];
            start[i] = length;
            length += i - first[i] + 1;
        }
        if (factor.length < length) {
            factor = Arrays.copyOf(factor, Math.max(FULL, 2 * length));
        }
    }

    /** Forward and backward substitution, in place. */
    void solve(double[] unknown) {
        for (int i = 0; i < size; i++) {
            double sum = unknown[i];
            for (int k = first[i]; k < i; k++) {
                sum -= factor[start[i] + k - first[i]] * unknown[k];
            }
            unknown[i] = sum / factor[start[i] + i - first[i]];
        }
        for (int i = size - 1; i >= 0; i--) {
            double x = unknown[i] / factor[start[i] + i - first[i]];
            unknown[i] = x;
            for (int k = first[i]; k < i; k++) {
                unknown[k] -= factor[start[i] + k - first[i]] * x;
            }
        }
    }
}
