package rigibo.backend.contact.solve;

import rigibo.backend.algebra.EnvelopeFactor;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

import java.util.Arrays;

/**
 * The matrix K = J·M⁻¹·Jᵀ of a set of single rows, with their compliances on its diagonal, factored
 * as L·U within its envelope, which in a stack is a band of six rows. If contacts slide or roll on,
 * their loads cause friction too, and K + s·μ·J·M⁻¹·Tᵀ is not symmetric. If none does, U = D·Lᵀ
 * takes half the work.
 *
 * <p>The velocity V of a hub is unknown, too: K then counts the other bodies alone, its rows read
 * K·Δj + H·V = −w, and what they bring to the hub is its momentum, Hᵀ·Δj − V = 0, where V and the
 * columns H count the hub's mass by halves. Hubs come after all rows they share with other bodies.
 */
final class RowFactor {

    private static final int NONE = -1;

    /** Most unknowns of hubs. */
    private static final int MOST_OF_HUBS = FlatRows.AXES * ContactOrder.MOST_HUBS;

    /** Work of solving a row of a set besides factoring, in multiplications. */
    private static final int WORK_OF_ROW = 60;

    /** Work of writing a non-zero entry of the matrix, in multiplications. */
    private static final int WORK_OF_ENTRY = 10;

    private final PackedContacts contacts;
    private final FlatRows rows;
    private final ContactOrder order;

    /** The factored set, in the order of contacts. */
    private int[] factored = new int[0];

    /** By row of the factored set: the friction and rolling that go with a load, otherwise 0. */
    private double[] sliding = new double[0];

    private double[] rolling = new double[0];

    private boolean isSymmetric = true;

    /** By flat row: its compliance, 1/kg. */
    private double[] give;

    private int size;

    private final EnvelopeFactor factor = new EnvelopeFactor();

    /** By place in the order: the first row of the set from there on. */
    private int[] firstInSet = new int[0];

    /** Number of rows of the factored set before the unknowns of hubs, and of these unknowns. */
    private int beforeHubs = NONE;

    private int ofHubs;

    /** The unknowns of rows and hubs, if there are hubs. */
    private double[] withHubs = new double[0];

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
        double loaded = contacts.shareLoaded();
        return loaded * loaded * loaded * order.work();
    }

    void forget() {
        size = 0;
        beforeHubs = NONE;
        ofHubs = 0;
        factor.lay(0);
    }

    private void reserve() {
        if (withHubs.length < FlatRows.KINDS * contacts.count + MOST_OF_HUBS) {
            int capacity = FlatRows.KINDS * contacts.pair.length;
            factored = Arrays.copyOf(factored, capacity);
            sliding = Arrays.copyOf(sliding, capacity);
            rolling = Arrays.copyOf(rolling, capacity);
            factor.reserve(capacity + MOST_OF_HUBS);
            withHubs = new double[capacity + MOST_OF_HUBS];
            firstInSet = new int[contacts.pair.length + 1];
        }
    }

    /**
     * Factors the matrix of a set with the rows' own compliances, from the first row on that
     * differs from the last set.
     */
    void factorize(int[] set, int count) {
        factorize(set, count, rows.give);
    }

    /** Factors it with other compliances, by flat row in 1/kg. */
    void factorize(int[] set, int count, double[] compliances) {
        give = compliances;
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
            sliding[i] = rows.following(set[i], FlatRows.TANGENT);
            rolling[i] = rows.following(set[i], FlatRows.ROLL);
            isSymmetric &= sliding[i] == 0 && rolling[i] == 0;
        }
        size = count;
        int before = beforeHubs;
        findPlaces();
        layEnvelope();
        for (int i = same; i < beforeHubs; i++) {
            writeRow(i);
        }
        if (same < beforeHubs || beforeHubs != before) {
            writeHubs();
        }
        for (int i = Math.max(same, beforeHubs); i < size; i++) {
            writeRow(i);
        }
    }

    private void writeRow(int i) {
        int at = place(i);
        factor.clear(at);
        writeEntries(i);
        // Of a redundant row only its compliance is left on the diagonal.
        factor.eliminate(at, isSymmetric, give[factored[i]]);
    }

    /** The place of a row of the set among all unknowns. */
    private int place(int i) {
        return i < beforeHubs ? i : i + ofHubs;
    }

    private boolean isFactored(int i, int k) {
        return factored[i] == k
                && sliding[i] == rows.following(k, FlatRows.TANGENT)
                && rolling[i] == rows.following(k, FlatRows.ROLL);
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
        beforeHubs = firstInSet[order.beforeHubs];
        ofHubs = FlatRows.AXES * order.hubCount;
    }

    /** Lays out the envelope: a row's begins at the first row that may share a body with it. */
    private void layEnvelope() {
        for (int i = 0; i < size; i++) {
            factor.first[place(i)] = firstInSet[order.firstNeighbour[factored[i] / FlatRows.KINDS]];
        }
        for (int i = 0; i < ofHubs; i++) {
            factor.first[beforeHubs + i] = firstOfHub(i / FlatRows.AXES);
        }
        factor.lay(size + ofHubs);
    }

    /** The first row of the set that acts on a hub. */
    private int firstOfHub(int hub) {
        int entry = order.hubs[hub] / Motions.STRIDE;
        int first = order.beforeHubs;
        for (int at = order.start[entry]; at < order.start[entry + 1]; at++) {
            first = Math.min(first, order.place[order.ofBodies[at]]);
        }
        return firstInSet[first];
    }

    /** Writes the equations of the hubs' momenta. */
    private void writeHubs() {
        for (int at = beforeHubs; at < beforeHubs + ofHubs; at++) {
            int hub = order.hubs[(at - beforeHubs) / FlatRows.AXES];
            int axis = (at - beforeHubs) % FlatRows.AXES;
            factor.clear(at);
            for (int i = factor.first[at]; i < beforeHubs; i++) {
                factor.writeLower(at, i, rows.toHub(factored[i], hub, axis));
                if (!isSymmetric) {
                    factor.writeUpper(at, i, rows.ofHub(factored[i], hub, axis));
                }
            }
            work += WORK_OF_ENTRY * (beforeHubs - factor.first[at]);
            factor.writeLower(at, at, -1);
            factor.eliminate(at, isSymmetric, 0);
        }
    }

    /** Writes the responses between a row and those before it that share a body with it. */
    private void writeEntries(int i) {
        int row = order.order[factored[i] / FlatRows.KINDS];
        writeEntries(i, contacts.bodyA[row]);
        writeEntries(i, contacts.bodyB[row]);
        int k = factored[i];
        int at = place(i);
        factor.writeLower(at, at, rows.answerTo(k, k) + give[k]);
        if (i >= beforeHubs) {
            writeEntriesOfHubs(at, k);
        }
    }

    private void writeEntriesOfHubs(int at, int k) {
        for (int i = 0; i < ofHubs; i++) {
            int hub = order.hubs[i / FlatRows.AXES];
            int axis = i % FlatRows.AXES;
            factor.writeLower(at, beforeHubs + i, rows.ofHub(k, hub, axis));
            if (!isSymmetric) {
                factor.writeUpper(at, beforeHubs + i, rows.toHub(k, hub, axis));
            }
        }
    }

    private void writeEntries(int i, int body) {
        if (!order.connects(body)) {
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
        if (ofHubs == 0) {
            factor.solve(unknown);
            return;
        }
        int after = size - beforeHubs;
        System.arraycopy(unknown, 0, withHubs, 0, beforeHubs);
        Arrays.fill(withHubs, beforeHubs, beforeHubs + ofHubs, 0);
        System.arraycopy(unknown, beforeHubs, withHubs, beforeHubs + ofHubs, after);
        factor.solve(withHubs);
        System.arraycopy(withHubs, 0, unknown, 0, beforeHubs);
        System.arraycopy(withHubs, beforeHubs + ofHubs, unknown, beforeHubs, after);
    }
}
