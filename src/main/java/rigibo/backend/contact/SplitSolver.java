package rigibo.backend.contact;

import static rigibo.backend.contact.BodyFactor.PER_BODY;
import static rigibo.backend.contact.SingleRows.ROWS_PER_CONTACT;
import static rigibo.backend.contact.SingleRows.TANGENT;

import rigibo.backend.setup.SolveMethod;

import java.util.Arrays;

/**
 * Solves all rows of a wide pile at once. Which of a thousand contacts carry the load of a pyramid
 * is not to be found by trying sets of them. So what the rows ask for as equations and what they
 * may carry are split (the alternating direction method of multipliers; S. Boyd et al., Distributed
 * Optimization and Statistical Learning via ADMM, 2011): the equations, softened by R, are solved
 * exactly, the impulses are taken to their bounds, and the difference is remembered and asked for
 * again.
 *
 * <p>With impulses j that start at j₀ and leave the speeds w, an iteration is (K + R)·(x − j₀) =
 * R·(z − u − j₀) − w, z = x + u within bounds, u = x + u − z. The matrix never changes. It is
 * solved by the bodies: x − j₀ = R⁻¹·(b − J·v) where (M + Jᵀ·R⁻¹·J)·v = Jᵀ·R⁻¹·b, with three
 * unknowns a body and a band as wide as the pile.
 */
final class SplitSolver implements WholeSolver {

    /** Largest island in rows, and one that hardly moves. */
    private static final int MOST_ROWS = 1200;

    private static final int MOST_ROWS_IF_CALM = 6000;

    /** Multiplications that factoring one may take. */
    private static final double MOST_WORK = 1e6;

    private static final double MOST_WORK_IF_CALM = 8e6;

    /** How much softer a row is than a free body, as a share; a tenth is near the fastest. */
    private static final double SOFTNESS = 0.1;

    /** Each iteration goes this much farther than it is told. */
    private static final double OVERSHOOT = 1.6;

    /**
     * Iterations that a substep of the game is worth in all. What was poured and still settles
     * would take ten times as many, in vain: it looks the same, and the next substep goes on. A
     * step of fewer substeps is worth as many, and one of more as much more as it is finer.
     */
    private static final int MOST_ITERATIONS = 60;

    private static final int SUBSTEPS_OF_GAME = 4;

    /** Iterations after which something must have come nearer. */
    private static final int ITERATIONS_TO_TELL = 8;

    /**
     * Share of the fastest speed that is left unsolved at any accuracy: the last digits are dear.
     */
    static final double FINEST = 1e-5;

    /** How many times the fastest speed two bodies may close at: each twice as fast. */
    private static final double CLOSING = 4;

    /** Iterations that an overlap is worth; the next substep goes on. */
    private static final int MOST_CORRECTIONS = 20;

    /** Share of the widest overlap to be taken back that may be missed. */
    private static final double CORRECTED = 1e-3;

    private final Motions motions;
    private final Rows rows;
    private final OverlapSolver overlap;
    private final SingleRows single;
    private final ContactOrder order;
    private final BodyFactor factor;

    /** The rows, normals before the tangent of their contact, and those that were factored. */
    private int[] set = new int[64];

    private int size;

    /** Made in this substep, and how many it is worth. */
    private int iterations;

    private final int mostIterations;

    private int[] factored = new int[64];
    private int factoredSize;

    /** By row: the places of its bodies, its six derivatives, what it gives way. */
    private int[] placeA = new int[64];

    private int[] placeB = new int[64];
    private double[] gradient = new double[64 * 2 * PER_BODY];
    private double[] softness = new double[64];
    private double[] give = new double[64];

    /** By row: the speed or gap asked about, the impulse it began with, z and u. */
    private double[] asked = new double[64];

    private double[] began = new double[64];
    private double[] within = new double[64];
    private double[] beyond = new double[64];
    private double[] right = new double[64];

    /** By body: three speeds, and at the end those of what does not move. */
    private double[] speed = new double[48];

    /** A solver that tries the harder the more substeps an accuracy asks for. */
    SplitSolver(Motions motions, Rows rows, OverlapSolver overlap, int substeps) {
        int ratio = Math.max(SUBSTEPS_OF_GAME / substeps, substeps / SUBSTEPS_OF_GAME);
        mostIterations = MOST_ITERATIONS * Math.max(1, ratio);
        this.motions = motions;
        this.rows = rows;
        this.overlap = overlap;
        single = new SingleRows(motions, rows);
        order = new ContactOrder(motions, rows);
        factor = new BodyFactor(motions, rows, order);
    }

    /** Begins the packed island, unless it is too wide; a calm one may be wider. */
    boolean prepare(boolean isCalm) {
        int count = ROWS_PER_CONTACT * rows.count;
        if (count > (isCalm ? MOST_ROWS_IF_CALM : MOST_ROWS)) {
            return false;
        }
        forget();
        order.find();
        return factor.layOut() <= (isCalm ? MOST_WORK_IF_CALM : MOST_WORK);
    }

    @Override
    public SolveMethod method() {
        return SolveMethod.SPLITTING;
    }

    @Override
    public void begin() {
        iterations = 0;
    }

    @Override
    public boolean isSpent() {
        return iterations >= mostIterations;
    }

    @Override
    public void forget() {
        factoredSize = 0;
    }

    @Override
    public void solve(double h, int substep, double settled, double fastest) {
        factorize(substep, h * CLOSING * fastest);
        for (int i = 0; i < size; i++) {
            began[i] = rows.data[impulseAt(i)];
            double v = single.relative(set[i], Motions.VX, Motions.VY, Motions.SPIN);
            double open = isTangent(i) ? 0 : openPerSecond(i, h);
            asked[i] = v + give[i] * began[i] - single.ownSpeed(set[i]) + open;
        }
        search(SOFTNESS * settled, MOST_ITERATIONS);
        for (int i = 0; i < size; i++) {
            rows.data[impulseAt(i)] = within[i];
            single.push(set[i], within[i] - began[i], Motions.VX, Motions.VY, Motions.SPIN);
        }
    }

    @Override
    public double finestShare() {
        return FINEST;
    }

    /** What overlaps parts as far as wanted, and no gap closes. */
    @Override
    public void correct(double h, int substep, double fastest) {
        if (!overlap.isAnyWanted(0, h, substep)) {
            return;
        }
        factorize(substep, h * CLOSING * fastest);
        double widest = 0;
        for (int i = 0; i < size; i++) {
            began[i] = 0;
            asked[i] = 0;
            if (!isTangent(i)) {
                double wanted = overlap.wanted(contact(i), set[i] % ROWS_PER_CONTACT, h);
                asked[i] = wanted > 0 ? -wanted : h * openPerSecond(i, h);
                widest = Math.max(widest, wanted);
            }
        }
        search(CORRECTED * widest, MOST_CORRECTIONS);
        for (int i = 0; i < size; i++) {
            single.push(set[i], within[i], Motions.DX, Motions.DY, Motions.TURN);
        }
    }

    /** Whether no row of the same contact stands before it. */
    private boolean isFirst(int i) {
        return i == 0 || contact(i - 1) != contact(i);
    }

    private int contact(int i) {
        return set[i] / ROWS_PER_CONTACT;
    }

    private boolean isTangent(int i) {
        return set[i] % ROWS_PER_CONTACT == TANGENT;
    }

    private int impulseAt(int i) {
        return contact(i) * Rows.STRIDE + SingleRows.impulseColumn(set[i]);
    }

    /** The speed at which a gap of a normal row may close within h seconds, m/s. */
    private double openPerSecond(int i, double h) {
        return Math.max(0, motions.gap(rows, contact(i), set[i] % ROWS_PER_CONTACT)) / h;
    }

    /**
     * Chooses the rows that take part in a substep, those loaded or as near as said in m, and
     * factors them, unless it was done.
     */
    private void factorize(int substep, double near) {
        reserve();
        size = 0;
        for (int i = 0; i < rows.count; i++) {
            int row = order.order[i];
            if (rows.firstSubstep[row] <= substep) {
                chooseNear(row, near);
            }
        }
        if (Arrays.equals(set, 0, size, factored, 0, factoredSize)) {
            return;
        }
        System.arraycopy(set, 0, factored, 0, size);
        factoredSize = size;
        factor.clear();
        for (int i = 0; i < size; i++) {
            int id = set[i];
            placeA[i] = factor.placeOf(rows.bodyA[contact(i)]);
            placeB[i] = factor.placeOf(rows.bodyB[contact(i)]);
            single.writeGradient(id, gradient, 2 * PER_BODY * i);
            give[i] = single.give(id);
            softness[i] = SOFTNESS * single.response(id, id);
            double weight = 1 / (softness[i] + give[i]);
            factor.couple(placeA[i], placeB[i], gradient, 2 * PER_BODY * i, weight);
        }
        factor.factorize();
    }

    /** A gap too wide to close would only stiffen what its bodies do. */
    private void chooseNear(int row, double near) {
        int before = size;
        for (int point = 0; point < rows.points[row]; point++) {
            boolean isLoaded = rows.data[row * Rows.STRIDE + Rows.IMPULSE0 + point] > 0;
            if (isLoaded || motions.gap(rows, row, point) <= near) {
                set[size++] = ROWS_PER_CONTACT * row + point;
            }
        }
        if (size > before && rows.data[row * Rows.STRIDE + Rows.FRICTION] > 0) {
            set[size++] = ROWS_PER_CONTACT * row + TANGENT;
        }
    }

    private void reserve() {
        if (set.length < ROWS_PER_CONTACT * rows.count) {
            int capacity = ROWS_PER_CONTACT * rows.pair.length;
            set = new int[capacity];
            factored = new int[capacity];
            placeA = new int[capacity];
            placeB = new int[capacity];
            gradient = new double[2 * PER_BODY * capacity];
            softness = new double[capacity];
            give = new double[capacity];
            asked = new double[capacity];
            began = new double[capacity];
            within = new double[capacity];
            beyond = new double[capacity];
            right = new double[capacity];
            factoredSize = 0;
        }
        if (speed.length < PER_BODY * motions.count) {
            speed = new double[PER_BODY * motions.slots.length];
        }
    }

    /**
     * Iterates from what is, until an iteration changes no speed by more than is said, or several
     * have brought nothing: where loads are carried by more contacts than are needed, and one of
     * these asks in the last digits for a speed that the others do not allow, they shift the load
     * among themselves for ever.
     */
    private void search(double settled, int most) {
        for (int i = 0; i < size; i++) {
            within[i] = began[i];
            boolean parts = !isTangent(i) && began[i] == 0 && asked[i] > 0;
            beyond[i] = parts ? -asked[i] / softness[i] : 0;
        }
        int last = Math.min(mostIterations, iterations + most);
        double before = Double.POSITIVE_INFINITY;
        boolean isNearing = true;
        double left;
        do {
            solveEquations();
            left = takeToBounds();
            iterations++;
            if (iterations % ITERATIONS_TO_TELL == 0) {
                isNearing = left < before;
                before = left;
            }
        } while (left > settled && isNearing && iterations < last);
    }

    /** Writes to {@code right} the change of each impulse that the softened equations ask for. */
    private void solveEquations() {
        int ground = PER_BODY * factor.count();
        Arrays.fill(speed, 0, ground, 0);
        for (int i = 0; i < size; i++) {
            right[i] = softness[i] * (within[i] - beyond[i] - began[i]) - asked[i];
            double pushed = right[i] / (softness[i] + give[i]);
            int g = 2 * PER_BODY * i;
            int a = PER_BODY * placeA[i];
            int b = PER_BODY * placeB[i];
            speed[a] += pushed * gradient[g];
            speed[a + 1] += pushed * gradient[g + 1];
            speed[a + 2] += pushed * gradient[g + 2];
            speed[b] += pushed * gradient[g + 3];
            speed[b + 1] += pushed * gradient[g + 4];
            speed[b + 2] += pushed * gradient[g + 5];
        }
        factor.solve(speed);
        Arrays.fill(speed, ground, ground + PER_BODY, 0);
        for (int i = 0; i < size; i++) {
            int g = 2 * PER_BODY * i;
            int a = PER_BODY * placeA[i];
            int b = PER_BODY * placeB[i];
            double met =
                    speed[a] * gradient[g]
                            + speed[a + 1] * gradient[g + 1]
                            + speed[a + 2] * gradient[g + 2]
                            + speed[b] * gradient[g + 3]
                            + speed[b + 1] * gradient[g + 4]
                            + speed[b + 2] * gradient[g + 5];
            right[i] = (right[i] - met) / (softness[i] + give[i]);
        }
    }

    /**
     * Takes the impulses to their bounds, a tangent to that of the load its contact now has;
     * returns the largest speed by which the two halves still differ, or changed.
     */
    private double takeToBounds() {
        double most = 0;
        double load = 0;
        for (int i = 0; i < size; i++) {
            double solved = began[i] + right[i];
            double wanted = OVERSHOOT * solved + (1 - OVERSHOOT) * within[i] + beyond[i];
            double bounded;
            if (isTangent(i)) {
                double cone = rows.data[contact(i) * Rows.STRIDE + Rows.FRICTION] * load;
                bounded = Math.max(-cone, Math.min(cone, wanted));
            } else {
                bounded = Math.max(0, wanted);
                load = isFirst(i) ? bounded : load + bounded;
            }
            double change = Math.max(Math.abs(bounded - solved), Math.abs(bounded - within[i]));
            most = Math.max(most, softness[i] * change);
            beyond[i] = wanted - bounded;
            within[i] = bounded;
        }
        return most;
    }
}
