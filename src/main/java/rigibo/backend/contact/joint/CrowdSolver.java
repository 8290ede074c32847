package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Effort;
import rigibo.backend.contact.row.MissedWidth;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.DataStorage;

import java.util.Arrays;

/**
 * Solves islands of many joints and contacts. All equations are eliminated together, which is cheap
 * along an {@link AssemblyTree}. Contacts, limits and motors are solved in passes, and equations
 * hold again after each pass. So joints are exact under any load, and only rows with bounds are
 * approximate.
 */
final class CrowdSolver {

    /** Passes in a usual substep at any cost; the next substep starts from their result. */
    private static final int USUAL_PASSES = 24;

    /**
     * Most passes in a usual substep. With 24, bodies in heaps of a hundred ragdolls overlapped by
     * a quarter of their width and were thrown.
     */
    private static final int MOST_PASSES = 96;

    /**
     * Row visits in a substep after which no more than the usual passes are made. It limits the
     * slowest step.
     */
    private static final int MOST_ASKED = 400_000;

    /** Passes after which equations are solved and rows exchanged again. */
    private static final int PASSES = 16;

    /**
     * Change of speed that does not count, as a share of the fastest speed after a kick and of that
     * before it. A crowd at rest has only the speed of the kick, and would creep with the larger
     * share. Both shares are smaller if substeps are longer than those of GAME, since their kicks
     * are larger.
     */
    private static final double QUIET = 0.003;

    private static final double QUIET_IN_MOTION = 0.03;

    /** Interval in passes at which rows are visited that the last pass did not change. */
    private static final int ALL = 3;

    /** Share of the change that does not count below which a row is not changed. */
    private static final double LEFT = 0.1;

    /**
     * Depth by which a contact may sink in before further passes follow, as a multiple of the width
     * that may be missed.
     */
    private static final double SUNK = 6;

    /** Energy that may be gained, as a share of the kinetic energy. */
    private static final double GAINED = 1e-4;

    private final Motions motions;
    private final NeutralRows rows;
    private final EquationFactor factor;
    private final EquationList equations;
    private final AssemblyTree tree;
    private final ContactRows contactRows;
    private final CrowdEquations held;
    private final BoundedRows bounded;
    private final GroupVelocities velocities;
    private final Responses responses;
    private final CrowdPlaces places;
    private final CrowdOverlap overlap;

    /** By group: whether other equations hold in it than before. */
    private boolean[] isOther = new boolean[16];

    /** By group: whether a contact presses on one of its bodies. */
    private boolean[] isPressed = new boolean[16];

    /** Velocities before a kick's impulses, laid out as the motions. */
    private double[] free = new double[64];

    /** By row: its speed before impulses, m/s. */
    private double[] freeSpeed = new double[64];

    private double freeEnergy;
    private int usualPasses;
    private int mostPasses;

    private final boolean isExact;

    /** Number of substeps relative to the game's, at most 1. */
    private final double shorter;

    /** How far a contact may sink in a substep, in widths. */
    private final double sunk;

    CrowdSolver(
            DataStorage data,
            Motions motions,
            PackedContacts contacts,
            NeutralRows rows,
            JointPlaces jointPlaces,
            Poses poses,
            PackedJoints packed,
            ContactRows contactRows,
            Accuracy accuracy) {
        this.motions = motions;
        this.rows = rows;
        this.contactRows = contactRows;
        factor = new EquationFactor(motions, rows);
        equations = factor.equations();
        tree = factor.tree();
        isExact = Effort.isExact(accuracy);
        shorter = Math.min(1, Effort.timesGame(accuracy));
        sunk = SUNK * MissedWidth.of(accuracy);
        held = new CrowdEquations(motions, rows, jointPlaces, poses, factor, accuracy);
        velocities = new GroupVelocities(data.bodies, motions, rows, factor);
        responses = new Responses(motions, rows, factor, velocities);
        bounded =
                new BoundedRows(
                        rows, jointPlaces, contactRows, packed, equations, responses, velocities);
        places =
                new CrowdPlaces(rows, jointPlaces, factor, bounded, velocities, held.missedPlace());
        overlap = new CrowdOverlap(motions, contacts, rows, responses, velocities, accuracy);
    }

    /** Number of multiplications since the last call. */
    double takeWork() {
        return factor.takeWork();
    }

    /** Number of row solutions since the last call. */
    long takeSolves() {
        return bounded.takeSolves();
    }

    /** Begins an island. If it has fewer substeps than usual, each gets the passes of several. */
    void beginIsland(int usual, int substeps) {
        int times = Math.max(1, usual / substeps);
        usualPasses = times * USUAL_PASSES;
        mostPasses = times * MOST_PASSES;
        factor.forget();
    }

    /**
     * Begins with rows that were just written for a part of h seconds; joints start with a share of
     * their impulses in the last kick.
     */
    void begin(double h, double share) {
        if (freeSpeed.length < rows.count) {
            freeSpeed = new double[rows.bodies.length];
        }
        factor.layOut();
        bounded.begin(share);
        factor.changeAll();
        places.correct(h);
    }

    /** Stores velocities after a kick and before any impulse. */
    void takeFree() {
        int length = motions.count * Motions.STRIDE;
        if (free.length < length) {
            free = new double[motions.data.length];
            isOther = new boolean[motions.slots.length];
            isPressed = new boolean[motions.slots.length];
        }
        System.arraycopy(motions.data, 0, free, 0, length);
        freeEnergy = motions.energy(motions.data);
        for (int row = 0; row < rows.count; row++) {
            if (!rows.holdsPlace[row]) {
                freeSpeed[row] = rows.speed(row);
            }
        }
    }

    /**
     * Solves the rows, which are written, for a drift of h seconds; contacts start with their last
     * impulses.
     *
     * @param before speed of the fastest body before the kick, m/s
     * @param fastest speed of the fastest body after it, m/s
     * @param noise energy that may be gained, J
     * @param finer share of the usual residual that equations of large groups may have
     */
    void solve(double h, double before, double fastest, double noise, double finer) {
        double quiet = shorter * Math.max(QUIET * fastest, QUIET_IN_MOTION * before);
        held.begin(velocities.areAnyLarge() ? finer : 1);
        warm();
        bounded.addContacts();
        responses.begin();
        run(quiet, h, true);
        if (isGained(noise)) {
            bounded.release();
            factor.changeAll();
            responses.begin();
            run(quiet, h, false);
            if (isGained(noise)) {
                bounded.release();
                settle(false);
            }
        }
        contactRows.store();
    }

    /** Whether a row may do work: a spring, or a motor that does not only brake. */
    private boolean drives(int row) {
        boolean isBrake = rows.target[row] == 0 && rows.lower[row] < rows.upper[row];
        return rows.joint[row] != NeutralRows.NONE && !rows.holdsPlace[row] && !isBrake;
    }

    /** Energy gained by impulses that can do no work, J. */
    private double gained() {
        double sum = motions.energy(motions.data) - freeEnergy;
        for (int row = 0; row < rows.count; row++) {
            if (drives(row)) {
                sum -= rows.impulse[row] * (freeSpeed[row] + rows.speed(row)) / 2;
            }
        }
        return sum;
    }

    /** Sets the impulses of joints to those of the last kick. */
    private void warm() {
        bounded.warm();
        for (int e = 0; e < equations.count; e++) {
            int row = equations.row[e];
            if (row != EquationList.NONE) {
                rows.impulse[row] = bounded.carried(row);
            }
        }
    }

    /**
     * Alternates passes and exchanges until no speed changes by more than {@code quiet} m/s and no
     * contact would sink in too far in h seconds.
     */
    private void run(double quiet, double h, boolean mayExchange) {
        int passes = velocities.areAnyLarge() ? 1 : PASSES;
        bounded.beginPasses();
        settle(true);
        boolean isOpen = bounded.areAny();
        for (int pass = 0; isOpen && isWorth(pass); pass += passes) {
            velocities.take();
            rows.bound();
            bounded.beginAnew();
            isOpen = !pass(pass, passes, quiet, h);
            settle(false);
            if (mayExchange && pass + passes < mostPasses) {
                // After the last pass, no pass could answer to other equations.
                isOpen |= exchange();
            }
        }
    }

    /** Whether more energy was gained than {@code noise}, J, and a share of the kinetic energy. */
    private boolean isGained(double noise) {
        return !motions.isAnyDriven && !(gained() <= noise + GAINED * freeEnergy);
    }

    private boolean isWorth(int pass) {
        return pass < usualPasses || pass < mostPasses && bounded.asked() < MOST_ASKED;
    }

    /** Makes a number of passes, or fewer if they converge; returns whether they did. */
    private boolean pass(int first, int passes, double quiet, double h) {
        boolean isDone = false;
        for (int i = 0; i < passes && !isDone; i++) {
            boolean isBack = (first + i) % 2 == 1;
            double change = bounded.pass(isBack, i % ALL == 0, LEFT * quiet);
            isDone = change <= quiet && !bounded.areSinking(h, sunk);
            if (!isDone && i + 1 < passes) {
                bounded.accelerate();
            }
        }
        return isDone;
    }

    private boolean exchange() {
        Arrays.fill(isOther, 0, tree.groups, false);
        boolean isAny = bounded.leave(tree, isOther);
        if (isAny) {
            bounded.beginWay();
            responses.forget(isOther);
            for (int group = 0; group < tree.groups; group++) {
                if (isOther[group]) {
                    factor.change(group);
                    held.ask(group);
                    held.settle(group, false);
                }
            }
        }
        return isAny;
    }

    /**
     * Computes velocities from all impulses, then solves equations. If {@code anew}, equations
     * start from impulses of 0, so that nothing remains of impulses that change no velocity.
     */
    private void settle(boolean anew) {
        System.arraycopy(free, 0, motions.data, 0, motions.count * Motions.STRIDE);
        for (int row = 0; row < rows.count; row++) {
            if (rows.impulse[row] != 0) {
                rows.apply(row, rows.impulse[row]);
            }
        }
        for (int group = 0; group < tree.groups; group++) {
            if (held.areOpen(group)) {
                held.settle(group, anew);
            }
        }
    }

    /**
     * Holds the places of equations at the end of a drift of h seconds, except in groups that
     * contacts press. Contacts are not solved again, so that the tension of a rope would pull it
     * into the pulley it runs over. At EXACT, pressed groups are held as well: substeps are short
     * there, and the energy that this keeps counts for more.
     */
    void holdPlaces(double h) {
        Arrays.fill(isPressed, 0, tree.groups, false);
        for (int row = 0; row < rows.count && !isExact; row++) {
            if (rows.isPoint(row) && rows.impulse[row] > 0) {
                notePressed(row);
            }
        }
        held.holdPlaces(h, isPressed);
    }

    private void notePressed(int row) {
        for (int i = 0; i < rows.bodies[row]; i++) {
            int entry = rows.body[row * NeutralRows.BODIES + i] / Motions.STRIDE;
            int body = equations.bodyOfEntry(entry);
            if (body != EquationList.NONE) {
                isPressed[tree.groupOf[body]] = true;
            }
        }
    }

    /** Removes overlap after a drift of h seconds. */
    void correctOverlap(double h) {
        overlap.correct(h);
    }
}
