package rigibo.backend.contact.solve;

import static rigibo.backend.contact.solve.FlatRows.KINDS;
import static rigibo.backend.contact.solve.FlatRows.ROLL;
import static rigibo.backend.contact.solve.FlatRows.TANGENT;

import rigibo.backend.contact.row.Displacement;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.KeptOverlap;

/**
 * Removes the overlap of a small island by one elimination. Rows that carry or overlap, and those
 * on which bodies stand on the ground, become equations between displacements: gaps open as far as
 * wanted, and rows that hold continue to hold.
 *
 * <p>The less a row carries, the softer it is, so that one whose load fades gives way little by
 * little. If it were either an equation or none, and redundant contacts shared a load, round-off
 * would choose which of them are equations, and so the motion of bodies.
 */
final class HeldOverlap {

    /**
     * Speed that a row's load or displacement amounts to, as a share of what a free body gains in a
     * step, at which the row is as soft as its own body: small beside any load that counts, and
     * large beside the round-off of loads.
     */
    static final double FADES = 1e-6;

    /** Share of that speed below which a row is left out. */
    private static final double FADED = 1e-2;

    /**
     * Compliance of each row, as a share of its effective inverse mass: it makes redundant rows
     * that contradict each other open by their mean.
     */
    static final double COMPLIANCE = 1e-7;

    private final Motions motions;
    private final PackedContacts contacts;
    private final OverlapSolver overlap;
    private final ContactOrder order;
    private final FlatRows rows;
    private final RowFactor factor;
    private final Displacement way;

    /** The rows that are equations. */
    private int[] set = new int[64];

    private int size;

    /** By row of the set: the distance by which it is to open, m; solved: its push, kg·m. */
    private double[] unknown = new double[64];

    /** By flat row: its compliance, 1/kg. */
    private double[] give = new double[64];

    /** Speed at which a row is as soft as its own body, m/s. */
    private double fading;

    HeldOverlap(
            Motions motions,
            PackedContacts contacts,
            OverlapSolver overlap,
            ContactOrder order,
            FlatRows rows,
            RowFactor factor) {
        this.motions = motions;
        this.contacts = contacts;
        this.overlap = overlap;
        this.order = order;
        this.rows = rows;
        this.factor = factor;
        way = new Displacement(motions);
    }

    /**
     * Moves bodies after a substep of h seconds, where the flat rows are laid out and read. A free
     * body gains {@code gained} m/s in the step.
     */
    void correct(double h, int substep, double gained) {
        fading = FADES * gained;
        rows.followNone();
        size = 0;
        double widest = 0;
        for (int place = 0; place < contacts.count; place++) {
            int row = order.order[place];
            if (contacts.firstSubstep[row] <= substep && choose(place, row, h)) {
                double width = contacts.width(row);
                widest = Math.max(widest, width);
            }
        }
        solve();
        way.begin();
        for (int i = 0; i < size; i++) {
            rows.move(set[i], unknown[i]);
        }
        limitWay(overlap.mostPush() * widest * h);
    }

    /** Solves the set, in the memory of the factor of velocities, which is lost. */
    private void solve() {
        factor.forget();
        factor.clearWork();
        factor.factorize(set, size, give);
        factor.solve(unknown);
        contacts.work.multiplications += factor.work();
        factor.forget();
    }

    /** Makes room for the packed island, so that no later step has to. */
    void reserve() {
        if (give.length < KINDS * contacts.count) {
            int capacity = KINDS * contacts.pair.length;
            set = new int[capacity];
            unknown = new double[capacity];
            give = new double[capacity];
        }
    }

    /** Chooses the rows of a contact; returns whether one of its gaps is to open. */
    private boolean choose(int place, int row, double h) {
        int before = size;
        boolean isAnyWanted = false;
        double load = 0;
        for (int point = 0; point < contacts.points[row]; point++) {
            int k = KINDS * place + point;
            double wanted = overlap.wanted(row, point, h);
            double holds = isOnGround(row, point) ? Double.POSITIVE_INFINITY : speed(k);
            choose(k, holds + wanted / h, wanted);
            isAnyWanted |= wanted > 0;
            load += rows.impulse[k];
        }
        if (size > before) {
            chooseBounded(KINDS * place + TANGENT, load);
            chooseBounded(KINDS * place + ROLL, load);
        }
        return isAnyWanted;
    }

    /** Chooses a tangent or rolling row by how far it is from its bound. */
    private void chooseBounded(int k, double load) {
        double share = rows.share(k);
        if (share > 0) {
            choose(k, share * load * rows.answer[k] - Math.abs(speed(k)), 0);
        }
    }

    /** Speed that a row's impulse gives its own bodies, m/s. */
    private double speed(int k) {
        return rows.impulse[k] * rows.answer[k];
    }

    /** Chooses a row that holds by {@code holds} m/s and should open by {@code wanted} m. */
    private void choose(int k, double holds, double wanted) {
        if (holds > FADED * fading) {
            double soft = fading / holds;
            give[k] = (COMPLIANCE + soft * soft) * rows.answer[k];
            unknown[size] = wanted;
            set[size++] = k;
        }
    }

    /**
     * Whether a point touches the ground. Bodies on it do not yield, so that their neighbours move
     * all the way.
     */
    private boolean isOnGround(int row, int point) {
        double width = contacts.width(row);
        return row >= contacts.groundStart
                && motions.gap(contacts, row, point) <= KeptOverlap.LEAST * width;
    }

    /**
     * Limits the displacement of any body, m. Otherwise contradicting overlaps, of a body between
     * two immovable ones, would be resolved by moving it around them.
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
}
