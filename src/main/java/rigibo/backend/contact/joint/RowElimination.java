package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * K = J·M⁻¹·Jᵀ of a set of rows, with their compliances on its diagonal, factored as L·D·Lᵀ within
 * its envelope. D may be negative, since some parts of a composed substep go back in time.
 */
final class RowElimination {

    private static final int NONE = -1;

    private final Motions motions;
    private final NeutralRows rows;
    private final RowOrder order;

    /** The rows of the set, in their order. */
    private int[] set = new int[64];

    private int size;

    /** Whether a row is in the set. */
    private boolean[] isIn = new boolean[64];

    /** The lower triangle by rows, each from its first entry on; the start of each row; and D. */
    private double[] lower = new double[1024];

    int[] start = new int[65];
    int[] first = new int[64];
    private double[] pivot = new double[64];
    private double[] unknown = new double[64];

    /** By entry of the motions: the first row of the set with it, and its last derivative. */
    private int[] firstOf = new int[16];

    private int[] lastOf = new int[16];

    /** By derivative: the previous one of the same body. By row: its number in the set. */
    private int[] before = new int[256];

    private int[] number = new int[64];

    private boolean isFactored;

    /**
     * Number of rows, from the first on, that are factored. A row of the factor depends only on
     * those before it, so that a row which enters or leaves the set costs only the rows after it.
     */
    private int factored;

    /** Compliance of every row, as a share of its response. */
    private double regular = NeutralRows.REGULAR;

    /** Multiplications made in the island, and its budget of them for a step. */
    private double work;

    private double worth;

    RowElimination(Motions motions, NeutralRows rows) {
        this.motions = motions;
        this.rows = rows;
        order = new RowOrder(motions, rows);
    }

    /** Begins an island with a budget of multiplications. */
    void beginIsland(double most) {
        work = 0;
        worth = most;
    }

    /** Multiplications made in the island. */
    double work() {
        return work;
    }

    /** Adds multiplications made by another elimination of the island's rows. */
    void count(double multiplications) {
        work += multiplications;
    }

    /** Whether the island's budget is spent. */
    boolean isSpent() {
        return work > worth;
    }

    /** Begins with rows that were just written; the set is empty. */
    void begin() {
        order.find();
        int capacity = rows.bodies.length;
        if (set.length < rows.count) {
            set = new int[capacity];
            isIn = new boolean[capacity];
            start = new int[capacity + 1];
            first = new int[capacity];
            pivot = new double[capacity];
            unknown = new double[capacity];
            number = new int[capacity];
            before = new int[capacity * NeutralRows.BODIES];
        }
        if (firstOf.length < motions.count) {
            firstOf = new int[motions.slots.length];
            lastOf = new int[motions.slots.length];
        }
        Arrays.fill(isIn, 0, rows.count, false);
        forget();
    }

    /**
     * Sets the compliance of every row as a share of its response, usually {@link
     * NeutralRows#REGULAR}.
     */
    void regularize(double share) {
        regular = share;
        forget();
    }

    /** Discards the factor, since rows have changed; the set stays. */
    void forget() {
        isFactored = false;
        factored = 0;
    }

    boolean isIn(int row) {
        return isIn[row];
    }

    /** Adds a row to the set or removes it. */
    void put(int row, boolean isInSet) {
        isFactored &= isIn[row] == isInSet;
        isIn[row] = isInSet;
    }

    /** Number of multiplications for factoring all rows. */
    double workOfAll() {
        begin();
        listSet(true);
        layFirsts();
        double all = 0;
        for (int i = 0; i < size; i++) {
            double width = i - first[i] + 1;
            all += width * width / 2;
        }
        return all;
    }

    /** Lays out the set and its envelope, unless it is factored. */
    void lay() {
        if (!isFactored) {
            listSet(false);
            layEnvelope();
        }
    }

    /** Factors the set, unless it is factored. */
    void factorize() {
        if (isFactored) {
            return;
        }
        lay();
        Arrays.fill(lastOf, 0, motions.count, NONE);
        for (int i = 0; i < factored; i++) {
            link(i);
        }
        for (int i = factored; i < size; i++) {
            assemble(i);
            link(i);
            eliminate(i);
        }
        factored = size;
        isFactored = true;
    }

    private void listSet(boolean all) {
        size = 0;
        for (int i = 0; i < rows.count; i++) {
            int row = order.order[i];
            if (all || isIn[row]) {
                if (size < factored && set[size] != row) {
                    factored = size;
                }
                number[row] = size;
                set[size++] = row;
            }
        }
        factored = Math.min(factored, size);
    }

    private void layEnvelope() {
        int length = layFirsts();
        if (lower.length < length) {
            lower = Arrays.copyOf(lower, 2 * length);
        }
    }

    private int layFirsts() {
        Arrays.fill(firstOf, 0, motions.count, NONE);
        int length = 0;
        for (int i = 0; i < size; i++) {
            int row = set[i];
            first[i] = i;
            for (int k = 0; k < rows.bodies[row]; k++) {
                int entry = rows.body[row * NeutralRows.BODIES + k] / Motions.STRIDE;
                if (firstOf[entry] == NONE) {
                    firstOf[entry] = i;
                }
                first[i] = Math.min(first[i], firstOf[entry]);
            }
            start[i] = length;
            length += i - first[i];
        }
        return length;
    }

    /**
     * Writes a row of K: its responses to the rows before it that share a body with it, and to
     * itself.
     */
    private void assemble(int i) {
        int row = set[i];
        Arrays.fill(lower, start[i], start[i] + i - first[i], 0);
        for (int k = 0; k < rows.bodies[row]; k++) {
            int at = row * NeutralRows.BODIES + k;
            int entry = rows.body[at] / Motions.STRIDE;
            for (int other = lastOf[entry]; other != NONE; other = before[other]) {
                int otherRow = other / NeutralRows.BODIES;
                lower[start[i] + number[otherRow] - first[i]] +=
                        rows.through(row, k, otherRow, other % NeutralRows.BODIES);
            }
        }
        pivot[i] = rows.response[row] * (1 + regular) + rows.give[row];
    }

    /** Links a row with its bodies, for the rows after it. */
    private void link(int i) {
        int row = set[i];
        for (int k = 0; k < rows.bodies[row]; k++) {
            int at = row * NeutralRows.BODIES + k;
            int entry = rows.body[at] / Motions.STRIDE;
            before[at] = lastOf[entry];
            lastOf[entry] = at;
        }
    }

    /** With c = L·D of the row: cⱼ = Kⱼ − Σ cₖ·Lⱼₖ, then Lⱼ = cⱼ/Dⱼ and D = K − Σ cⱼ·Lⱼ. */
    private void eliminate(int i) {
        int at = start[i] - first[i];
        for (int j = first[i]; j < i; j++) {
            int from = Math.max(first[i], first[j]);
            int to = start[j] - first[j];
            double sum = lower[at + j];
            for (int k = from; k < j; k++) {
                sum -= lower[at + k] * lower[to + k];
            }
            lower[at + j] = sum;
            work += j - from;
        }
        double left = pivot[i];
        for (int j = first[i]; j < i; j++) {
            double c = lower[at + j];
            lower[at + j] = c / pivot[j];
            left -= c * lower[at + j];
        }
        pivot[i] = rows.pivot(set[i], left);
    }

    /** Asks for the removal of the residuals of the set's rows; returns the largest, m/s. */
    double askForResiduals() {
        double worst = 0;
        for (int i = 0; i < size; i++) {
            double residual = rows.residual(set[i]);
            unknown[i] = -residual;
            worst = Math.max(worst, rows.inMetres(set[i], residual));
        }
        return worst;
    }

    /**
     * Solves for the impulses of the set's rows that give all changes asked for since it was
     * factored; {@link #answer} returns them.
     */
    void solve() {
        work += size == 0 ? 0 : 2.0 * (start[size - 1] + size);
        for (int i = 0; i < size; i++) {
            double sum = unknown[i];
            int at = start[i] - first[i];
            for (int k = first[i]; k < i; k++) {
                sum -= lower[at + k] * unknown[k];
            }
            unknown[i] = sum;
        }
        for (int i = 0; i < size; i++) {
            unknown[i] /= pivot[i];
        }
        for (int i = size - 1; i >= 0; i--) {
            double x = unknown[i];
            int at = start[i] - first[i];
            for (int k = first[i]; k < i; k++) {
                unknown[k] -= lower[at + k] * x;
            }
        }
    }

    /**
     * Factors the set and solves for the impulses that give changes of speed in m/s, stated by row.
     */
    void solveFor(double[] changes) {
        factorize();
        for (int i = 0; i < size; i++) {
            unknown[i] = changes[set[i]];
        }
        solve();
    }

    /** Number of rows in the set. */
    int size() {
        return size;
    }

    /** Number of a row within the set. */
    int numberOf(int row) {
        return number[row];
    }

    /** A row of the set. */
    int row(int i) {
        return set[i];
    }

    /** Impulse of a row of the set in the solution. */
    double answer(int i) {
        return unknown[i];
    }
}
