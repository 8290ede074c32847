package rigibo.backend.contact;

import java.util.Arrays;

/**
 * A positive matrix with three rows a body, x, y and turn, that couples bodies which touch,
 * factored by Cholesky within its envelope. Bodies stand in the order of their first contacts,
 * which runs from one end of the pile to the other, so the envelope is as narrow as the pile.
 */
final class BodyFactor {

    static final int PER_BODY = 3;

    private static final int NOWHERE = -1;

    private final Motions motions;
    private final Rows rows;
    private final ContactOrder order;

    /** For each entry of the motions its place in the order, or NOWHERE. */
    private int[] place = new int[16];

    /** How many bodies have a place; also the place of all that do not move. */
    private int count;

    /** For each place the first place it is coupled with. */
    private int[] firstPlace = new int[16];

    /** Lower triangle by rows, from the first entry on, and where each row starts. */
    private double[] factor = new double[256];

    private int[] start = new int[49];

    BodyFactor(Motions motions, Rows rows, ContactOrder order) {
        this.motions = motions;
        this.rows = rows;
        this.order = order;
    }

    /**
     * Lays out the packed island, whose contacts are ordered.
     *
     * @return multiplications that factoring takes
     */
    double layOut() {
        if (place.length < motions.count) {
            int capacity = motions.slots.length;
            place = new int[capacity];
            firstPlace = new int[capacity];
            start = new int[PER_BODY * capacity + 1];
        }
        Arrays.fill(place, 0, motions.count, NOWHERE);
        count = 0;
        for (int i = 0; i < rows.count; i++) {
            givePlace(rows.bodyA[order.order[i]]);
            givePlace(rows.bodyB[order.order[i]]);
        }
        for (int row = 0; row < rows.count; row++) {
            int a = placeOf(rows.bodyA[row]);
            int b = placeOf(rows.bodyB[row]);
            if (a != count && b != count) {
                int later = Math.max(a, b);
                firstPlace[later] = Math.min(firstPlace[later], Math.min(a, b));
            }
        }
        return layEnvelope();
    }

    private void givePlace(int offset) {
        int entry = offset / Motions.STRIDE;
        if (place[entry] == NOWHERE && motions.data[offset + Motions.INVERSE_MASS] > 0) {
            firstPlace[count] = count;
            place[entry] = count++;
        }
    }

    private double layEnvelope() {
        double work = 0;
        int length = 0;
        for (int i = 0; i < PER_BODY * count; i++) {
            int width = i - first(i) + 1;
            start[i] = length;
            length += width;
            work += width * (double) width / 2;
        }
        start[PER_BODY * count] = length;
        return work;
    }

    private int first(int i) {
        return PER_BODY * firstPlace[i / PER_BODY];
    }

    /** The place of the body at an offset of the motions; {@link #count} for what does not move. */
    int placeOf(int offset) {
        int at = place[offset / Motions.STRIDE];
        return at == NOWHERE ? count : at;
    }

    int count() {
        return count;
    }

    /** Begins a matrix: the masses alone. */
    void clear() {
        int length = start[PER_BODY * count];
        if (factor.length < length) {
            factor = new double[2 * length];
        }
        Arrays.fill(factor, 0, length, 0);
        for (int entry = 1; entry < motions.count; entry++) {
            if (place[entry] != NOWHERE) {
                int at = entry * Motions.STRIDE;
                double mass = 1 / motions.data[at + Motions.INVERSE_MASS];
                double inertia = motions.data[at + Motions.INVERSE_INERTIA];
                add(place[entry], 0, place[entry], 0, mass);
                add(place[entry], 1, place[entry], 1, mass);
                // What does not turn keeps a row of its own, which nothing is coupled with.
                add(place[entry], 2, place[entry], 2, inertia > 0 ? 1 / inertia : 1);
            }
        }
    }

    /**
     * Adds weight·g·gᵀ, where g has three entries at {@code at} for the body at place a, and three
     * after them for b.
     */
    void couple(int a, int b, double[] g, int at, double weight) {
        for (int i = 0; i < PER_BODY; i++) {
            for (int j = 0; j < PER_BODY; j++) {
                if (a != count && j <= i) {
                    add(a, i, a, j, weight * g[at + i] * g[at + j]);
                }
                if (b != count && j <= i) {
                    add(b, i, b, j, weight * g[at + PER_BODY + i] * g[at + PER_BODY + j]);
                }
                if (a != count && b < a) {
                    add(a, i, b, j, weight * g[at + i] * g[at + PER_BODY + j]);
                }
                if (b != count && a < b) {
                    add(b, i, a, j, weight * g[at + PER_BODY + i] * g[at + j]);
                }
            }
        }
    }

    private void add(int body, int i, int other, int j, double value) {
        int line = PER_BODY * body + i;
        factor[start[line] + PER_BODY * other + j - first(line)] += value;
    }

    void factorize() {
        for (int i = 0; i < PER_BODY * count; i++) {
            int firstOfI = first(i);
            int shiftI = start[i] - firstOfI;
            for (int j = firstOfI; j <= i; j++) {
                int from = Math.max(firstOfI, first(j));
                int shiftJ = start[j] - first(j);
                double sum = factor[shiftI + j] - product(shiftI + from, shiftJ + from, j - from);
                factor[shiftI + j] = i == j ? Math.sqrt(sum) : sum / factor[shiftJ + j];
            }
        }
    }

    /** The sum of products of two stretches of the factor, in four lanes for the processor. */
    private double product(int a, int b, int length) {
        double[] f = factor;
        double sum0 = 0;
        double sum1 = 0;
        double sum2 = 0;
        double sum3 = 0;
        int k = 0;
        for (; k + 3 < length; k += 4) {
            sum0 += f[a + k] * f[b + k];
            sum1 += f[a + k + 1] * f[b + k + 1];
            sum2 += f[a + k + 2] * f[b + k + 2];
            sum3 += f[a + k + 3] * f[b + k + 3];
        }
        for (; k < length; k++) {
            sum0 += f[a + k] * f[b + k];
        }
        return sum0 + sum1 + (sum2 + sum3);
    }

    /** Forward and backward substitution, in place. */
    void solve(double[] x) {
        double[] f = factor;
        int size = PER_BODY * count;
        for (int i = 0; i < size; i++) {
            int from = first(i);
            int shift = start[i] - from;
            double even = x[i];
            double odd = 0;
            int k = from;
            for (; k + 1 < i; k += 2) {
                even -= f[shift + k] * x[k];
                odd -= f[shift + k + 1] * x[k + 1];
            }
            if (k < i) {
                even -= f[shift + k] * x[k];
            }
            x[i] = (even + odd) / f[shift + i];
        }
        for (int i = size - 1; i >= 0; i--) {
            int from = first(i);
            int shift = start[i] - from;
            double solved = x[i] / f[shift + i];
            x[i] = solved;
            for (int k = from; k < i; k++) {
                x[k] -= f[shift + k] * solved;
            }
        }
    }
}
