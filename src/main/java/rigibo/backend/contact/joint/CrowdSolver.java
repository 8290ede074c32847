package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.MissedWidth;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.DataStorage;

import java.util.Arrays;

/**
 * Solves islands of many joints and contacts. Their equations are eliminated all at once, which
 * takes little along an {@link AssemblyTree}; contacts, limits and motors are passed over, and
 * after each pass the equations hold again. So joints are exact at any load, and only what has
 * bounds is as near as passes bring it.
 */
final class CrowdSolver {

    /**
     * Passes in a usual substep, whatever they cost; the next one begins with what they came to.
     */
    private static final int USUAL_PASSES = 24;

    /**
     * Passes in a usual substep at most. With 24, heaps of a hundred ragdolls left bodies in each
     * other by a quarter of their width, and threw them.
     */
    private static final int MOST_PASSES = 96;

    /** Rows asked in a substep before more than the usual passes end: bounds the slowest step. */
    private static final int MOST_ASKED = 400_000;

    /** Passes before what holds is found anew. */
    private static final int PASSES = 16;

    /**
     * Share of the fastest speed below which a change does not count, after a kick and before it. A
     * crowd at rest has only what the kick gave it, and would otherwise creep. Both are smaller if
     * substeps are longer than the game's, since a kick adds more in them.
     */
    private static final double QUIET = 0.003;

    private static final double QUIET_IN_MOTION = 0.03;

    /** Every how many passes rows are asked that did not change before. */
    private static final int ALL = 3;

    /** Share of that below which a row is left as it is. */
    private static final double LEFT = 0.1;

    /** Factor on what may be missed by which a contact may sink in before further passes follow. */
    private static final double SUNK = 6;

    /** Energy that may be gained, as a share of that of motion. */
    private static final double GAINED = 1e-4;

    private final Motions motions;
    private final NeutralRows rows;
    private final EquationFactor factor;
    private final EquationList equations;
    private final AssemblyTree tree;
    private final ContactRows contactRows;
    private final CrowdEquations held;
    private final BoundedRows bounded;
    private final Responses responses;
    private final CrowdPlaces places;
    private final CrowdOverlap overlap;

    /** By group whether other equations hold in it. */
    private boolean[] isOther = new boolean[16];

    /** By group whether a contact presses on one of its bodies. */
    private boolean[] isPressed = new boolean[16];

    /** Velocities before a kick's impulses, as the motions. */
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
            JointRows jointRows,
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
        isExact = accuracy.substeps() >= Accuracy.EXACT.substeps();
        shorter = Math.min(1, accuracy.substeps() / (double) Accuracy.GAME.substeps());
        sunk = SUNK * MissedWidth.of(accuracy);
        held = new CrowdEquations(motions, rows, jointRows, poses, factor, accuracy);
        responses = new Responses(data.bodies, motions, rows, factor);
        bounded = new BoundedRows(rows, jointRows, contactRows, packed, equations, responses);
        places = new CrowdPlaces(rows, jointRows, factor, bounded, responses, held.missedPlace());
        overlap = new CrowdOverlap(motions, contacts, rows, responses, accuracy);
    }

    /** Multiplications made since it was asked for last. */
    double takeWork() {
        return factor.takeWork();
    }

    /** Rows solved since it was asked for last. */
    long takeSolves() {
        return bounded.takeSolves();
    }

    /** Begins an island that is given fewer, longer substeps, each of which stands for several. */
    void beginIsland(int usual, int substeps) {
        int times = Math.max(1, usual / substeps);
        usualPasses = times * USUAL_PASSES;
        mostPasses = times * MOST_PASSES;
        factor.forget();
    }

    /**
     * Begins with rows that were just written for a part of h seconds; joints give a share of what
     * they carried in the kick before.
     */
    void begin(double h, double share) {
        if (freeSpeed.length < rows.count) {
            freeSpeed = new double[rows.bodies.length];
        }
        factor.layOut();
        bounded.begin(share);
        factor.begin();
        places.correct(h);
    }

    /** Notes how bodies move after a kick and before any impulse. */
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
     * Solves for a substep of h seconds; contacts begin with what they carried before.
     *
     * @param before speed of the fastest body before the kick, m/s
     * @param fastest speed of the fastest body after it, m/s
     * @param noise energy that may be gained, J
     * @param finer share of the usual that equations of large groups may lack
     */
    void solve(double h, int substep, double before, double fastest, double noise, double finer) {
        double quiet = shorter * Math.max(QUIET * fastest, QUIET_IN_MOTION * before);
        held.begin(responses.areAnyLarge() ? finer : 1);
        contactRows.write(h, substep);
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

    /** Whether a row may do work: of a spring, or of a motor that does not only brake. */
    private boolean drives(int row) {
        boolean isBrake = rows.target[row] == 0 && rows.lower[row] < rows.upper[row];
        return rows.joint[row] != NeutralRows.NONE && !rows.holdsPlace[row] && !isBrake;
    }

    /** J that was gained by other impulses than those that may do work. */
    private double gained() {
        double sum = motions.energy(motions.data) - freeEnergy;
        for (int row = 0; row < rows.count; row++) {
            if (drives(row)) {
                sum -= rows.impulse[row] * (freeSpeed[row] + rows.speed(row)) / 2;
            }
        }
        return sum;
    }

    /** Begins with what joints carried in the kick before. */
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
     * Lets passes and exchanges follow each other until no speed changes by more than {@code quiet}
     * m/s, and nothing sinks in too far in h seconds.
     */
    private void run(double quiet, double h, boolean mayExchange) {
        int passes = responses.areAnyLarge() ? 1 : PASSES;
        bounded.beginPasses();
        settle(true);
        boolean isOpen = bounded.areAny();
        for (int pass = 0; isOpen && isWorth(pass); pass += passes) {
            responses.take();
            rows.bound();
            bounded.beginAnew();
            isOpen = !pass(pass, passes, quiet, h);
            settle(false);
            if (mayExchange && pass + passes < mostPasses) {
                // After the last pass nothing would answer what others hold from then on.
                isOpen |= exchange();
            }
        }
    }

    /** Whether more energy was gained than may be: noise, J, and a share of the motion's. */
    private boolean isGained(double noise) {
        return !motions.isAnyDriven && !(gained() <= noise + GAINED * freeEnergy);
    }

    private boolean isWorth(int pass) {
        return pass < usualPasses || pass < mostPasses && bounded.asked() < MOST_ASKED;
    }

    /** Makes so many passes, or fewer if they come to their end; returns whether they did. */
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
     * Finds what holds, and how bodies move, from all impulses of rows at bounds; anew, so that
     * nothing is left of impulses that change no body, or from what was found before.
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
     * Holds the places of equations at the end of a drift of h seconds, but where bodies are
     * pressed on: contacts are not asked again, so that the tension of a rope, say, would draw it
     * into the pulley that it runs over. At EXACT, whose substeps are short, the energy that this
     * keeps counts for more.
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

    /** Takes overlap back after a drift of h seconds. */
    void correctOverlap(double h) {
        overlap.correct(h);
    }
}
