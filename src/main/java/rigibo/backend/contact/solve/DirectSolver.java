package rigibo.backend.contact.solve;

import static rigibo.backend.contact.solve.FlatRows.KINDS;
import static rigibo.backend.contact.solve.FlatRows.TANGENT;

import rigibo.backend.contact.row.Displacement;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.Recovery;

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
public final class DirectSolver {

    /**
     * Share of the tolerance that elimination itself uses: the pass that checks the result solves
     * two points at once and sees the sum of their errors.
     */
    private static final double TO_SPARE = 0.5;

    /** Sets tried within one solve, for each substep; passes over the rows see to what is left. */
    private static final int TRIES_PER_SUBSTEP = 8;

    private final Motions motions;
    private final PackedContacts contacts;
    private final OverlapSolver overlap;
    private final FlatRows rows;
    private final ContactOrder order;
    private final RowFactor factor;
    private final NewtonSolver newton;
    private final int mostTries;

    /** Multiplications that a substep is worth. */
    private double worth;

    /** The present set of {@link FlatRows}, in their order. */
    private int[] set = new int[64];

    private int size;

    private double[] unknown = new double[64];

    /** By how much the rows of the set moved last, N·s. */
    private double[] moved = new double[64];

    /** By place in the order: the bound of the contact's friction, N·s. */
    private double[] cone = new double[64];

    /** Whether the rows are laid out as they are. */
    private boolean isLaidOut;

    /** A load that gives a row less speed than this in m/s is none. */
    private double least;

    /** What taking overlap back has moved. */
    private final Displacement way;

    /** A solver that tries the harder the more substeps an accuracy asks for. */
    public DirectSolver(
            Motions motions, PackedContacts contacts, OverlapSolver overlap, int substeps) {
        this.motions = motions;
        this.contacts = contacts;
        this.overlap = overlap;
        way = new Displacement(motions);
        order = new ContactOrder(motions, contacts);
        rows = new FlatRows(motions, contacts, order);
        factor = new RowFactor(contacts, rows, order);
        newton = new NewtonSolver(motions, contacts, order, rows, factor);
        mostTries = TRIES_PER_SUBSTEP * substeps;
    }

    /**
     * Begins the packed island, unless it is too large, or factoring all of its rows takes more
     * multiplications than a substep is worth.
     */
    public boolean prepare(double worthOfSubstep) {
        if (contacts.areCrowd()) {
            return false;
        }
        worth = worthOfSubstep;
        forget();
        order.find();
        return factor.workOfAll() <= worth;
    }

    /** The rows are not what they were: a factor of them is worth nothing. */
    public void forget() {
        factor.forget();
        isLaidOut = false;
    }

    /** Begins a substep: what was spent counts anew. */
    public void begin() {
        factor.clearWork();
    }

    /** Multiplications of this substep. */
    public double work() {
        return factor.work();
    }

    /** Whether what is left of the rows is not worth more in this substep. */
    public boolean isSpent() {
        return factor.work() > worth;
    }

    /** A lone disc's normal and friction do not feel each other: nothing is to be eliminated. */
    private boolean isUncoupled() {
        return contacts.count == 1 && contacts.points[0] == 1;
    }

    /**
     * Brings the rows to rest against each other, for a substep of h seconds, but for a speed of
     * {@code settled} m/s.
     *
     * @param isNearby finds the impulses nearest to those that there are, and not the least ones,
     *     which may be far, beyond a cone or a pull: a heap at rest would be taken apart on the way
     *     to them. What is squeezed in vain must not be solved so, for its impulses would grow for
     *     as long as it lasts.
     */
    public void solve(double h, int substep, double settled, boolean isNearby) {
        if (!isUncoupled()) {
            read(h, isNearby);
            Arrays.fill(rows.sliding, 0, contacts.count, 0);
            solveRead(substep, settled);
            rows.write();
        }
    }

    /**
     * The same near the solution, by Coulomb's law itself: what slides rubs by the load that is
     * found, and not by that of before. Returns whether that was possible; if not, all is as it
     * was.
     */
    public boolean solveByNewton(double h, int substep, double settled, boolean isNearby) {
        if (isUncoupled()) {
            return true;
        }
        read(h, isNearby);
        boolean isSolved = newton.solve(substep, settled, worth);
        if (isSolved) {
            rows.write();
        }
        return isSolved;
    }

    private void read(double h, boolean isNearby) {
        layOut();
        rows.read(h);
        if (isNearby) {
            System.arraycopy(rows.impulse, 0, rows.kept, 0, KINDS * contacts.count);
        } else {
            Arrays.fill(rows.kept, 0, KINDS * contacts.count, 0);
        }
    }

    /** Lays the rows out, if they are not what they were. */
    private void layOut() {
        if (!isLaidOut) {
            rows.layOut();
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

    /** Takes the overlap of loaded rows back, or of all that overlap where nothing is loaded. */
    public void correct(double h, int substep) {
        reserve();
        if (factor.size() == 0 || !factor.isSymmetric()) {
            layOut();
            Arrays.fill(rows.sliding, 0, contacts.count, 0);
            chooseOverlapping(h, substep);
            factor.factorize(set, size);
        }
        size = factor.writeSet(set);
        double widest = 0;
        for (int i = 0; i < size; i++) {
            int row = order.order[set[i] / KINDS];
            int kind = set[i] % KINDS;
            unknown[i] = kind == TANGENT ? 0 : overlap.wanted(row, kind, h);
            if (unknown[i] > 0) {
                widest =
                        Math.max(
                                widest,
                                contacts.data[row * PackedContacts.STRIDE + PackedContacts.WIDTH]);
            }
        }
        if (widest > 0) {
            factor.solve(unknown);
            way.begin();
            for (int i = 0; i < size; i++) {
                rows.move(set[i], unknown[i]);
            }
            limitWay(Recovery.MOST_PUSH * widest * h);
        }
    }

    private void chooseOverlapping(double h, int substep) {
        size = 0;
        for (int i = 0; i < contacts.count; i++) {
            int row = order.order[i];
            if (contacts.firstSubstep[row] <= substep) {
                for (int point = 0; point < contacts.points[row]; point++) {
                    if (overlap.wanted(row, point, h) > 0 || isOnGround(row, point)) {
                        set[size++] = KINDS * i + point;
                    }
                }
            }
        }
    }

    /** What lies on the ground or leans on it does not give way: its neighbour goes all the way. */
    private boolean isOnGround(int row, int point) {
        double width = contacts.data[row * PackedContacts.STRIDE + PackedContacts.WIDTH];
        return row >= contacts.groundStart
                && motions.gap(contacts, row, point) <= Recovery.KEPT_OVERLAP * width;
    }

    /**
     * Limits how far any body is moved, m. Contradicting overlaps, of a body between two that do
     * not give way, would otherwise be resolved by moving it around them.
     */
    private void limitWay(double most) {
        double farthest = 0;
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            double x = way.of(at + Motions.DX);
            double y = way.of(at + Motions.DY);
            farthest = Math.max(farthest, Math.max(Math.abs(x), Math.abs(y)));
        }
        if (farthest > most) {
            way.scaleAll(most / farthest);
        }
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
            cone = new double[contacts.pair.length];
        }
    }

    /**
     * Adds a contact's rows that carry load after their own next change. A row that is about to let
     * go would only shorten the step of all others.
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
        cone[place] = contacts.data[row * PackedContacts.STRIDE + PackedContacts.FRICTION] * load;
        int tangent = KINDS * place + TANGENT;
        double most = cone[place] * rows.answer[tangent];
        if (size > before && Math.abs(rows.answerAfterOwnChange(tangent)) < most) {
            set[size++] = tangent;
        }
    }

    /**
     * Goes to the solution, each row no farther than to its bound, if that lowers what is
     * minimized: ½jᵀKj + wᵀj, whose gradient is w.
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

    /** Goes towards the solution until the first bound is met, and drops the row that met it. */
    private void stepToFirstBound() {
        double step = 1;
        int met = -1;
        for (int i = 0; i < size; i++) {
            double change = withinBounds(set[i], unknown[i]);
            // A friction that its cone no longer holds has no room at all.
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

    /** Moves along the step as far as bounds allow; returns by how much the minimized rises, J. */
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
        if (k % KINDS != TANGENT) {
            return Math.max(change, -impulse);
        }
        double most = cone[k / KINDS];
        return Math.max(-most, Math.min(most, impulse + change)) - impulse;
    }
}
