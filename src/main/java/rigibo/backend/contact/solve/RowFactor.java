package rigibo.backend.contact.solve;

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

    /** L by rows and U by columns, from the first entry of each on, and where each starts. */
    private double[] lower = new double[0];

    private double[] upper = new double[0];

    private int[] start = new int[65];
    private int[] first = new int[64];

    /** The inverse of each entry of U's diagonal. */
    private double[] inverse = new double[64];

    /** For each place in the order the first row of the set from there on. */
    private int[] firstInSet = new int[65];

    private double work;

    RowFactor(PackedContacts contacts, FlatRows rows, ContactOrder order) {
        this.contacts = contacts;
        this.rows = rows;
        this.order = order;
    }

    /** Multiplications made since they were counted last. */
    double work() {
        return work;
    }

    void clearWork() {
        work = 0;
    }

    /** Multiplications that factoring takes where all rows are loaded, by their envelope. */
    double workOfAll() {
        double all = 0;
        for (int place = 0; place < contacts.count; place++) {
            double width = FlatRows.KINDS * (place - order.firstNeighbour[place] + 1);
            all += FlatRows.KINDS * width * width / 2;
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
        if (firstInSet.length <= contacts.count || first.length < FlatRows.KINDS * contacts.count) {
            int capacity = FlatRows.KINDS * contacts.pair.length;
            factored = Arrays.copyOf(factored, capacity);
            sliding = Arrays.copyOf(sliding, capacity);
            start = Arrays.copyOf(start, capacity + 1);
            first = Arrays.copyOf(first, capacity);
            inverse = Arrays.copyOf(inverse, capacity);
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
            Arrays.fill(lower, start[i], start[i + 1], 0);
            Arrays.fill(upper, start[i], start[i + 1], 0);
            writeEntries(i);
            eliminate(i);
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
        int length = 0;
        for (int i = 0; i < size; i++) {
            first[i] = firstInSet[order.firstNeighbour[factored[i] / FlatRows.KINDS]];
            start[i] = length;
            length += i - first[i] + 1;
        }
        start[size] = length;
        if (lower.length < length) {
            int capacity = Math.max(FULL, 2 * length);
            lower = Arrays.copyOf(lower, capacity);
            upper = Arrays.copyOf(upper, capacity);
        }
    }

    /** Writes what a row and those before it give each other: those that share a body with it. */
    private void writeEntries(int i) {
        int row = order.order[factored[i] / FlatRows.KINDS];
        writeEntries(i, contacts.bodyA[row]);
        writeEntries(i, contacts.bodyB[row]);
        lower[start[i + 1] - 1] += rows.give[factored[i]];
    }

    private void writeEntries(int i, int body) {
        if (body == 0) {
            return;
        }
        int entry = body / Motions.STRIDE;
        int column = start[i] - first[i];
        for (int at = order.start[entry]; at < order.start[entry + 1]; at++) {
            int place = order.place[order.ofBodies[at]];
            int end = Math.min(firstInSet[place + 1], i + 1);
            for (int j = firstInSet[place]; j < end; j++) {
                lower[column + j] = rows.answerTo(factored[i], factored[j]);
                work += WORK_OF_ENTRY;
                if (!isSymmetric) {
                    upper[column + j] = rows.answerTo(factored[j], factored[i]);
                    work += WORK_OF_ENTRY;
                }
            }
        }
    }

    /** Row i of L and column i of U, by those before them. */
    private void eliminate(int i) {
        int own = start[i] - first[i];
        for (int j = first[i]; j < i; j++) {
            int from = Math.max(first[i], first[j]);
            int mine = own + from;
            int other = start[j] - first[j] + from;
            double l = lower[own + j] - dot(lower, mine, upper, other, j - from);
            double u = l;
            if (!isSymmetric) {
                u = upper[own + j] - dot(upper, mine, lower, other, j - from);
                work += j - from;
            }
            lower[own + j] = l * inverse[j];
            upper[own + j] = u;
            work += j - from + 1;
        }
        double left = lower[own + i] - dot(lower, start[i], upper, start[i], i - first[i]);
        inverse[i] = 1 / pivot(left, factored[i]);
        work += i - first[i];
    }

    /** What is left on the diagonal; of a redundant row only what it gives way by is left. */
    private double pivot(double left, int k) {
        return Math.abs(left) > rows.give[k] ? left : rows.give[k];
    }

    /** A product of parts of two arrays, in four sums that do not wait for each other. */
    private static double dot(double[] a, int atA, double[] b, int atB, int length) {
        double sum0 = 0;
        double sum1 = 0;
        double sum2 = 0;
        double sum3 = 0;
        int k = 0;
        for (; k < length - 3; k += 4) {
            sum0 += a[atA + k] * b[atB + k];
            sum1 += a[atA + k + 1] * b[atB + k + 1];
            sum2 += a[atA + k + 2] * b[atB + k + 2];
            sum3 += a[atA + k + 3] * b[atB + k + 3];
        }
        for (; k < length; k++) {
            sum0 += a[atA + k] * b[atB + k];
        }
        return sum0 + sum1 + (sum2 + sum3);
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

    /** Forward and backward substitution, in place. */
    void solve(double[] unknown) {
        for (int i = 0; i < size; i++) {
            unknown[i] -= dot(lower, start[i], unknown, first[i], i - first[i]);
        }
        for (int i = size - 1; i >= 0; i--) {
            double x = unknown[i] * inverse[i];
            unknown[i] = x;
            int column = start[i] - first[i];
            for (int k = first[i]; k < i; k++) {
                unknown[k] -= upper[column + k] * x;
            }
        }
    }
}
