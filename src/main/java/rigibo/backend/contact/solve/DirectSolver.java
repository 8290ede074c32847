package rigibo.backend.contact.solve;

import static rigibo.backend.contact.solve.FlatRows.KINDS;
import static rigibo.backend.contact.solve.FlatRows.ROLL;
import static rigibo.backend.contact.solve.FlatRows.TANGENT;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

import java.util.Arrays;

/**
 * Solves all loaded rows of a small island at once. Passes carry a load through a stack of N bodies
 * only after some N² passes, and its bending after N⁴, so that a tower sways and a light box under
 * a heavy one sinks; one elimination solves both exactly.
 *
 * <p>The rows that carry load are solved as equations: K·Δj = −w with K = J·M⁻¹·Jᵀ (Baraff, "Fast
 * contact force computation for nonpenetrating rigid bodies", 1994). The step towards the solution
 * ends where the first impulse would pull or the first friction would leave its cone; that row is
 * dropped, and the rest is solved again. This is an active-set method whose kinetic energy never
 * rises from one step to the next. K is factored within its envelope, which in a stack is a band of
 * six rows.
 */
public final class DirectSolver {

    /**
     * Share of the tolerance that elimination may use, since the pass that checks the result solves
     * two points together and finds the sum of their errors.
     */
    private static final double TO_SPARE = 0.5;

    /** Most sets of rows tried in one solve, per substep of the accuracy; passes solve the rest. */
    private static final int TRIES_PER_SUBSTEP = 8;

    private final PackedContacts contacts;
    private final FlatRows rows;
    private final ContactOrder order;
    private final RowFactor factor;
    private final NewtonSolver newton;
    private final int mostTries;

    /** Budget of a substep, in multiplications. */
    private double worth;

    /** The present set of {@link FlatRows}, in their order. */
    private int[] set = new int[64];

    private int size;

    private double[] unknown = new double[64];

    /** By row of the set: its last change of impulse, N·s. */
    private double[] moved = new double[64];

    /** By flat row: bound of a contact's friction or rolling, N·s. */
    private double[] bound = new double[64];

    /** Whether the flat rows are up to date. */
    private boolean isLaidOut;

    /** Speed in m/s below which the load that causes it counts as none. */
    private double least;

    private final HeldOverlap held;

    /** Speed in m/s that a free body gains in the step. */
    private double free;

    /** Whether to find the impulses nearest to the present ones. */
    private boolean isNearby;

    /** A solver whose number of tries grows with the number of substeps. */
    public DirectSolver(
            Motions motions, PackedContacts contacts, OverlapSolver overlap, int substeps) {
        this.contacts = contacts;
        order = new ContactOrder(motions, contacts);
        rows = new FlatRows(motions, contacts, order);
        factor = new RowFactor(contacts, rows, order);
        newton = new NewtonSolver(motions, contacts, order, rows, factor);
        held = new HeldOverlap(motions, contacts, overlap, order, rows, factor);
        mostTries = TRIES_PER_SUBSTEP * substeps;
    }

    /**
     * Prepares the packed island. Returns false if it is too large, or if factoring all of its rows
     * takes more multiplications than the budget of a substep.
     *
     * @param worthOfSubstep budget of an island without rolling resistance, in multiplications
     * @param isNearby whether to find the impulses nearest to the present ones rather than the
     *     smallest ones. The smallest may be far away, beyond a cone or a pull, so that a heap at
     *     rest would be taken apart on the way to them. It must be false for a squeezed body, whose
     *     impulses would grow for as long as the squeezing lasts.
     * @param gained speed that a free body gains in the step, m/s
     */
    public boolean prepare(double worthOfSubstep, boolean isNearby, double gained) {
        this.isNearby = isNearby;
        free = gained;
        if (contacts.areCrowd()) {
            return false;
        }
        held.reserve();
        forget();
        order.find();
        worth = worthOfSubstep * order.timesByRolling();
        return factor.workOfAll() <= worth;
    }

    /** Discards the factor, since the rows have changed. */
    public void forget() {
        factor.forget();
        isLaidOut = false;
    }

    /** Starts a substep with a full budget. */
    public void begin() {
        factor.clearWork();
    }

    /** Multiplications done in this substep. */
    public double work() {
        return factor.work();
    }

    /** Whether the budget of this substep is spent. */
    public boolean isSpent() {
        return factor.work() > worth;
    }

    /**
     * Whether there is nothing to eliminate: a single disc's normal and friction are independent.
     */
    private boolean isUncoupled() {
        return contacts.count == 1 && contacts.points[0] == 1;
    }

    /**
     * Solves the rows for a substep of h seconds, to a residual of {@code settled} m/s. A point
     * that is about to lose its load keeps its impulse here; the pass before each round takes it
     * away.
     */
    public void solve(double h, int substep, double settled) {
        if (!isUncoupled()) {
            read(h);
            rows.followNone();
            solveRead(substep, settled);
            rows.write();
        }
    }

    /**
     * Solves the rows near the solution by Newton's method, where sliding friction follows from the
     * load being solved for rather than from the last one. Returns whether it succeeded; if not,
     * the state is restored.
     */
    public boolean solveByNewton(double h, int substep, double settled) {
        if (isUncoupled()) {
            return true;
        }
        read(h);
        boolean isSolved = newton.solve(substep, settled, worth);
        if (isSolved) {
            rows.write();
        }
        return isSolved;
    }

    private void read(double h) {
        layOut();
        rows.read(h);
        if (isNearby) {
            System.arraycopy(rows.impulse, 0, rows.kept, 0, KINDS * contacts.count);
        } else {
            Arrays.fill(rows.kept, 0, KINDS * contacts.count, 0);
        }
    }

    /** Lays out the flat rows, if they have changed. */
    private void layOut() {
        if (!isLaidOut) {
            rows.layOut(isNearby);
            isLaidOut = true;
        }
    }

    private void solveRead(int substep, double settled) {
        reserve();
        least = settled;
        chooseLoaded(substep);
        for (int i = 0;
                i < mostTries && !isSpent() && !(rows.worst(set, size) <= TO_SPARE * settled);
                i++) {
            factor.solveSet(set, size, unknown);
            if (stepToAllBounds()) {
                chooseLoaded(substep);
            } else {
                stepToFirstBound();
            }
        }
    }

    /**
     * Removes the overlap of loaded contacts ({@link HeldOverlap}), after a substep of h seconds.
     */
    public void correct(double h, int substep) {
        layOut();
        rows.read(h);
        held.correct(h, substep, free);
    }

    private void chooseLoaded(int substep) {
        size = 0;
        for (int place = 0; place < contacts.count; place++) {
            if (contacts.firstSubstep[order.order[place]] <= substep) {
                chooseLoadedOf(place);
            }
        }
    }

    private void reserve() {
        if (set.length < KINDS * contacts.count) {
            int capacity = KINDS * contacts.pair.length;
            set = new int[capacity];
            unknown = new double[capacity];
            moved = new double[capacity];
            bound = new double[capacity];
        }
    }

    /**
     * Adds the rows of a contact that would still carry load after their own next change. A row
     * that is about to lose its load would only shorten the step of all others.
     */
    private void chooseLoadedOf(int place) {
        int before = size;
        int row = order.order[place];
        double load = 0;
        for (int point = 0; point < contacts.points[row]; point++) {
            int k = KINDS * place + point;
            load += rows.impulse[k];
            if (rows.answerAfterOwnChange(k) > least) {
                set[size++] = k;
            }
        }
        if (size > before) {
            chooseBounded(KINDS * place + TANGENT, load);
            chooseBounded(KINDS * place + ROLL, load);
        }
    }

    /** Adds a tangent or rolling row that would stay within its bound after its own next change. */
    private void chooseBounded(int k, double load) {
        double share = rows.share(k);
        bound[k] = share * load;
        if (share > 0 && Math.abs(rows.answerAfterOwnChange(k)) < bound[k] * rows.answer[k]) {
            set[size++] = k;
        }
    }

    /**
     * Goes to the solution with each row clamped at its bound, if that lowers the objective ½jᵀKj +
     * wᵀj, whose gradient is w; returns whether it does.
     */
    private boolean stepToAllBounds() {
        if (moveBy() <= 0) {
            return true;
        }
        for (int i = 0; i < size; i++) {
            rows.push(set[i], -moved[i]);
        }
        return false;
    }

    /** Goes towards the solution up to the first bound, and drops the row that reached it. */
    private void stepToFirstBound() {
        double step = 1;
        int met = -1;
        for (int i = 0; i < size; i++) {
            double change = withinBounds(set[i], unknown[i]);
            // Friction that is already outside its cone cannot change at all.
            double room = change == unknown[i] ? 1 : Math.max(0, change / unknown[i]);
            if (room < step) {
                step = room;
                met = i;
            }
        }
        for (int i = 0; i < size; i++) {
            rows.push(set[i], withinBounds(set[i], step * unknown[i]));
        }
        if (met >= 0) {
            System.arraycopy(set, met + 1, set, met, size - met - 1);
            size--;
        }
    }

    /** Moves along the step as far as bounds allow; returns the rise of the objective, J. */
    private double moveBy() {
        double rise = 0;
        for (int i = 0; i < size; i++) {
            moved[i] = withinBounds(set[i], unknown[i]);
            rise += moved[i] * rows.approach(set[i]) / 2;
        }
        for (int i = 0; i < size; i++) {
            rows.push(set[i], moved[i]);
        }
        for (int i = 0; i < size; i++) {
            rise += moved[i] * rows.approach(set[i]) / 2;
        }
        return rise;
    }

    /** The part of a change that leaves its row within its bounds. */
    private double withinBounds(int k, double change) {
        double impulse = rows.impulse[k];
        return FlatRows.isPoint(k)
                ? Math.max(change, -impulse)
                : Math.max(-bound[k], Math.min(bound[k], impulse + change)) - impulse;
    }
}
