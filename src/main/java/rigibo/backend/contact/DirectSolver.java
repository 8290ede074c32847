package rigibo.backend.contact;

import static rigibo.backend.contact.SingleRows.ROWS_PER_CONTACT;
import static rigibo.backend.contact.SingleRows.TANGENT;

import java.util.Arrays;

/**
 * Solves all loaded rows of a small island at once. Passing over the contacts one by one carries a
 * load through a stack of N only after some N² passes, and its bending after N⁴, so that a tower
 * sways and a light box under a heavy one sinks; one elimination does both exactly.
 *
 * <p>The rows that carry load are taken as equations: K·Δj = −w with K = J·M⁻¹·Jᵀ (Baraff 1994).
 * The step towards the solution ends where the first impulse would pull or the first friction would
 * pass its cone; that row is left out, and the rest is solved again: an active-set method, whose
 * kinetic energy never rises from one step to the next. K is factored by Cholesky within its
 * envelope, which in a stack is a band of six rows.
 */
final class DirectSolver {

    /** Largest island in rows; beyond it the elimination costs more than it gains. */
    static final int MOST_ROWS = 192;

    /** Sets tried within one solve; passes over the rows see to what is left. */
    private static final int MOST_TRIES = 6;

    /** Compliance added to the diagonal, relative: decides where rows say the same twice. */
    private static final double COMPLIANCE = 1e-10;

    /** Relative growth of energy that round-off explains, and the energy in J of nothing moving. */
    private static final double ROUND_OFF = 1e-6;

    private static final double NO_ENERGY = 1e-12;

    /** An impulse may exceed the momentum it answers by this factor: a wedge of a thousandth. */
    private static final double MOST_LEVERAGE = 1e3;

    private final Motions motions;
    private final Rows rows;
    private final OverlapSolver overlap;
    private final SingleRows single;

    /** The rows of the present set: 3·contact + point, or + 2 for the tangent. */
    private int[] set = new int[64];

    private int size;

    /** The factored set, to see whether the factor still holds. */
    private int[] factored = new int[64];

    private int factoredSize;

    /** Lower triangle by rows, from the first entry of each row on, and where each row starts. */
    private double[] factor = new double[1024];

    private int[] start = new int[65];
    private int[] first = new int[64];
    private double[] unknown = new double[64];
    private double[] saved = new double[64];

    DirectSolver(Motions motions, Rows rows, OverlapSolver overlap) {
        this.motions = motions;
        this.rows = rows;
        this.overlap = overlap;
        single = new SingleRows(motions, rows);
    }

    /** Begins an island: the factor of the last one is worth nothing. */
    void prepare() {
        factoredSize = -1;
    }

    /** Whether the packed island is small enough. */
    boolean isSmallEnough() {
        return ROWS_PER_CONTACT * rows.count <= MOST_ROWS;
    }

    /** A lone disc's normal and friction do not feel each other: nothing is to be eliminated. */
    private boolean isUncoupled() {
        return rows.count == 1 && rows.points[0] == 1;
    }

    /** Brings the loaded rows to rest against each other, for a substep of h seconds. */
    void solve(double h, int substep) {
        if (isUncoupled()) {
            return;
        }
        save();
        double energy = motions.kineticEnergy();
        double momentum = motions.momentum();
        eliminate(h, substep);
        double given = rows.carried > 0 ? workOfSurfaces() : 0;
        double gained = motions.kineticEnergy() - given;
        boolean gainsEnergy = gained > energy * (1 + ROUND_OFF) + NO_ENERGY;
        if (gainsEnergy || largestChange() > MOST_LEVERAGE * momentum + NO_ENERGY) {
            restore();
        }
    }

    /** What the drives of running surfaces put in since the save, J: speed times impulse. */
    private double workOfSurfaces() {
        int offset = motions.count * Motions.STRIDE;
        double work = 0;
        for (int at = 0; at < rows.count * Rows.STRIDE; at += Rows.STRIDE) {
            double impulse = rows.data[at + Rows.IMPULSE_T] - saved[offset + at + Rows.IMPULSE_T];
            work += rows.data[at + Rows.SURFACE] * impulse;
        }
        return work;
    }

    /** By how much an impulse changed at most since the save, N·s. */
    private double largestChange() {
        int offset = motions.count * Motions.STRIDE;
        double most = 0;
        for (int at = 0; at < rows.count * Rows.STRIDE; at += Rows.STRIDE) {
            most = Math.max(most, change(offset, at + Rows.IMPULSE0));
            most = Math.max(most, change(offset, at + Rows.IMPULSE1));
            most = Math.max(most, change(offset, at + Rows.IMPULSE_T));
        }
        return most;
    }

    private double change(int offset, int column) {
        return Math.abs(rows.data[column] - saved[offset + column]);
    }

    /** Keeps velocities and impulses, to come back to. */
    private void save() {
        int motion = motions.count * Motions.STRIDE;
        int contact = rows.count * Rows.STRIDE;
        if (saved.length < motion + contact) {
            saved = new double[2 * (motion + contact)];
        }
        System.arraycopy(motions.data, 0, saved, 0, motion);
        System.arraycopy(rows.data, 0, saved, motion, contact);
    }

    /**
     * A body squeezed between what cannot give way has no solution that is at rest, or one by
     * impulses without measure: the equations answer with whatever lets it slip out. The passes
     * over the rows are gentler.
     */
    private void restore() {
        int motion = motions.count * Motions.STRIDE;
        System.arraycopy(saved, 0, motions.data, 0, motion);
        System.arraycopy(saved, motion, rows.data, 0, rows.count * Rows.STRIDE);
        factoredSize = -1;
    }

    private void eliminate(double h, int substep) {
        chooseLoaded(substep);
        for (int attempt = 0; attempt < MOST_TRIES && size > 0; attempt++) {
            factorize();
            for (int i = 0; i < size; i++) {
                unknown[i] = -approach(set[i], h);
            }
            if (rows.carried > 0) {
                aimAtSurfaces();
            }
            substitute();
            if (stepToBound() < 0) {
                return;
            }
        }
    }

    /** Rows that hold a body on a running surface bring it to the surface's speed. */
    private void aimAtSurfaces() {
        for (int i = 0; i < size; i++) {
            if (set[i] % ROWS_PER_CONTACT == TANGENT) {
                unknown[i] += rows.data[set[i] / ROWS_PER_CONTACT * Rows.STRIDE + Rows.SURFACE];
            }
        }
    }

    /** Takes the overlap of loaded rows back, with the factor of the last solve. */
    void correct(double h) {
        if (factoredSize <= 0) {
            return;
        }
        size = factoredSize;
        System.arraycopy(factored, 0, set, 0, size);
        boolean isAny = false;
        for (int i = 0; i < size; i++) {
            int kind = set[i] % ROWS_PER_CONTACT;
            unknown[i] = kind == TANGENT ? 0 : overlap.wanted(set[i] / ROWS_PER_CONTACT, kind, h);
            isAny |= unknown[i] > 0;
        }
        if (isAny) {
            substitute();
            for (int i = 0; i < size; i++) {
                single.push(set[i], unknown[i], Motions.DX, Motions.DY, Motions.TURN);
            }
        }
    }

    private void chooseLoaded(int substep) {
        if (set.length < ROWS_PER_CONTACT * rows.count) {
            int capacity = 2 * ROWS_PER_CONTACT * rows.count;
            set = new int[capacity];
            factored = Arrays.copyOf(factored, capacity);
            start = new int[capacity + 1];
            first = new int[capacity];
            unknown = new double[capacity];
            factoredSize = -1;
        }
        size = 0;
        for (int row = 0; row < rows.count; row++) {
            if (rows.firstSubstep[row] <= substep) {
                chooseLoadedOf(row);
            }
        }
    }

    private void chooseLoadedOf(int row) {
        double[] d = rows.data;
        int at = row * Rows.STRIDE;
        if (d[at + Rows.IMPULSE0] > 0) {
            set[size++] = ROWS_PER_CONTACT * row;
        }
        if (d[at + Rows.IMPULSE1] > 0) {
            set[size++] = ROWS_PER_CONTACT * row + 1;
        }
        double most = friction(row);
        if (most > 0 && Math.abs(d[at + Rows.IMPULSE_T]) < most) {
            set[size++] = ROWS_PER_CONTACT * row + TANGENT;
        }
    }

    private double friction(int row) {
        double[] d = rows.data;
        int at = row * Rows.STRIDE;
        return d[at + Rows.FRICTION] * (d[at + Rows.IMPULSE0] + d[at + Rows.IMPULSE1]);
    }

    /** Speed in m/s at which a row violates what it asks for. */
    private double approach(int id, double h) {
        int row = id / ROWS_PER_CONTACT;
        int kind = id % ROWS_PER_CONTACT;
        double v = single.relative(id, Motions.VX, Motions.VY, Motions.SPIN);
        return kind == TANGENT ? v : v + Math.max(0, motions.gap(rows, row, kind)) / h;
    }

    /**
     * Goes towards the solution until a bound is met and drops the row that met it.
     *
     * @return the place of the dropped row in the set, or -1 where the solution was reached
     */
    private int stepToBound() {
        double step = 1;
        int met = -1;
        for (int i = 0; i < size; i++) {
            double room = roomFor(set[i], unknown[i]);
            if (room < step) {
                step = room;
                met = i;
            }
        }
        for (int i = 0; i < size; i++) {
            int at = set[i] / ROWS_PER_CONTACT * Rows.STRIDE;
            double change = step * unknown[i];
            rows.data[at + SingleRows.impulseColumn(set[i])] += change;
            single.push(set[i], change, Motions.VX, Motions.VY, Motions.SPIN);
        }
        if (met >= 0) {
            drop(met);
        }
        return met;
    }

    /** The share of a change that its row can take before it meets its bound. */
    private double roomFor(int id, double change) {
        int row = id / ROWS_PER_CONTACT;
        double impulse = rows.data[row * Rows.STRIDE + SingleRows.impulseColumn(id)];
        if (id % ROWS_PER_CONTACT != TANGENT) {
            return change < 0 ? -impulse / change : 1;
        }
        double most = friction(row);
        double limit = change < 0 ? -most : most;
        return Math.abs(impulse + change) <= most ? 1 : Math.max(0, (limit - impulse) / change);
    }

    private void drop(int place) {
        int id = set[place];
        if (id % ROWS_PER_CONTACT != TANGENT) {
            rows.data[id / ROWS_PER_CONTACT * Rows.STRIDE + SingleRows.impulseColumn(id)] = 0;
        }
        System.arraycopy(set, place + 1, set, place, size - place - 1);
        size--;
    }

    /** Factors the matrix of the set, unless the last factor is of the same set. */
    private void factorize() {
        if (factoredSize == size && Arrays.equals(set, 0, size, factored, 0, size)) {
            return;
        }
        System.arraycopy(set, 0, factored, 0, size);
        factoredSize = size;
        layEnvelope();
        for (int i = 0; i < size; i++) {
            for (int j = first[i]; j <= i; j++) {
                double sum = single.response(set[i], set[j]) * (i == j ? 1 + COMPLIANCE : 1);
                int from = Math.max(first[i], first[j]);
                for (int k = from; k < j; k++) {
                    sum -= factor[start[i] + k - first[i]] * factor[start[j] + k - first[j]];
                }
                factor[start[i] + j - first[i]] =
                        i == j ? root(sum, set[i]) : sum / factor[start[j] + j - first[j]];
            }
        }
    }

    /** A row that repeats others leaves nothing on its diagonal; its compliance stays. */
    private double root(double remainder, int id) {
        return Math.sqrt(Math.max(remainder, COMPLIANCE * single.response(id, id)));
    }

    private void layEnvelope() {
        int length = 0;
        for (int i = 0; i < size; i++) {
            int j = 0;
            while (j < i
                    && !single.shareBody(set[i] / ROWS_PER_CONTACT, set[j] / ROWS_PER_CONTACT)) {
                j++;
            }
            first[i] = j;
            start[i] = length;
            length += i - j + 1;
        }
        if (factor.length < length) {
            factor = new double[2 * length];
        }
    }

    /** Forward and backward substitution, in place. */
    private void substitute() {
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
