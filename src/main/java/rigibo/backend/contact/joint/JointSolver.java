package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.FreshRows;
import rigibo.backend.contact.row.LockedAxes;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.SolveMethod;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.JointStore;

/**
 * Solves the joints of an island, with its contacts, for one substep after the other: velocities in
 * the middle of a substep are such that what joints hold is held at its end (J.-P. Ryckaert, G.
 * Ciccotti and H. Berendsen, Numerical integration of the Cartesian equations of motion of a system
 * with constraints, 1977), and after the last kick they are along what is held (H. C. Andersen,
 * Rattle, 1983). Both are symmetric in time and symplectic, so that a swing keeps its energy.
 */
public final class JointSolver {

    /** How far a place may be missed, as a share of the joint's arms and of the tolerance. */
    static final double MISSED = 1e-5;

    /** How far a place is off by round-off alone, as a share of the joint's arms. */
    static final double ROUND_OFF = 4e-16;

    /** Share of the fastest speed that may be left unsolved, per metre of the tolerance. */
    private static final double SETTLED = 1e-3;

    /**
     * Share of that where bodies hardly move before a kick, by at most so many times less than
     * after it: what rows give way by adds up along a chain, and would keep it from resting.
     */
    private static final double FINER = 1e-3;

    private static final double HARDLY = 1e-3;

    /** Work of contacts and equations that is round-off, as a share of the energy of motion. */
    private static final double MOST_WORK = 1e-6;

    /** Most work of equations in a kick whose places are held, as a share of the energy. */
    private static final double MOST_WORK_OF_TURNING = 0.1;

    /** Most work where Newton's steps do not reach the places: turning does not explain it. */
    private static final double MOST_WORK_IF_MISSED = 1e-4;

    /** Multiplications that one elimination is worth, and from EXACT on. */
    private static final double WORTH = 1e6;

    private static final double WORTH_IF_EXACT = 1e8;

    /**
     * Eliminations of all rows that an island is worth in a substep, and of the largest size in a
     * step; what takes more is left to passes. Newton's steps take some ten; what takes fifty tries
     * sets of rows that contradict each other.
     */
    private static final double ELIMINATIONS = 64;

    private static final double LARGEST_ELIMINATIONS = 32;

    /** Multiplications in a step that a small island is worth, whatever one elimination takes. */
    private static final double LEAST_WORTH = 1e6;

    /** Rows that passes solve in a step, unless that leaves a substep fewer than so many passes. */
    private static final int SOLVES = 1_000_000;

    private static final int LEAST_PASSES = 8;

    /** Rows up to which an island whose contacts may open and close is eliminated. */
    private static final int MOST_ROWS = 400;

    /** Rows with bounds up to which it is: more of them enter and leave the set without an end. */
    private static final int MOST_BOUNDED = 60;

    /** Rows of a contact or a joint, at least, as a rule. */
    private static final int LEAST_ROWS = 2;

    /**
     * Rows of an island that is small: its impacts are at their time, and what its equations do in
     * a kick is not held against it. In larger ones rows that contradict each other are common.
     */
    private static final int FEW_ROWS = 150;

    /** Rows times impacts that an island is worth in a substep. */
    private static final int STRUCK_ROWS = 1000;

    /** Passes over rows in a substep for each substep of a step. */
    private static final int PASSES_PER_SUBSTEP = 20;

    /** What stops are there, which of them are watched, and what happens when they are reached. */
    private final Stops stops;

    public final Strikes strikes;
    public final JointImpacts impacts;
    private final RowStates states = new RowStates();

    private final NeutralRows rows;
    private final HeldPlaces places;
    private final PlaceRecovery recovery;
    private final PackedJoints packed;
    private final Poses poses;
    private final JointRows jointRows;
    private final ContactRows contactRows;
    private final RowElimination elimination;
    private final RowSolver solver;
    private final JointResults results;
    private final Motions motions;
    private final RowWork work;
    private final RowPasses passes;
    private final CrowdSolver crowd;

    /** Axes along which bodies are kept from moving, or null where none is locked. */
    public final LockedAxes locks;

    /** What takes overlap back where bodies of an island are locked, or null likewise. */
    public final RowOverlap lockedOverlap;

    private final int substeps;

    /** Whether the packed island has anything that only pushes. */
    private boolean haveStops;

    /** Whether all rows are written where bodies are, without contacts: nothing has moved since. */
    private boolean areWritten;

    private int mostStrikes;

    private boolean isSmall;

    /** Passes over the island's rows in a substep. */
    private int mostPasses;

    private final double worth;

    /** Whether the island is small enough to be eliminated. */
    private boolean isWhole;

    /** How long the last kick was, s, and the next one as a share of it. */
    private double kicked;

    private double share;

    /** The fastest speed before the kick, m/s. */
    private double before;

    /** The last kick when it was kept, s. */
    private double keptKick;

    private final TautSubsteps taut;
    private final TautInertia inertia;

    /** Whether tautness may be answered by inertia at this accuracy. */
    private final boolean mayStiffen;

    /** Whether the island trembles faster than its substeps follow. */
    private boolean isTaut;

    private final ComposedSubsteps composed;
    private final SpringSubsteps springs;
    private final double tolerance;
    private final Islands islands;
    private final JointStore store;

    public JointSolver(
            DataStorage data,
            Motions motions,
            PackedContacts contacts,
            RowBuilder builder,
            FreshRows fresh,
            Accuracy accuracy) {
        this.motions = motions;
        boolean areLocks = data.bodies.lockedX != null;
        locks = areLocks ? new LockedAxes(data.bodies, motions) : null;
        rows = new NeutralRows(motions, locks);
        lockedOverlap = areLocks ? new RowOverlap(motions, contacts, rows, accuracy) : null;
        work = new RowWork(motions, rows);

        packed = new PackedJoints(data, builder);
        poses = new Poses(data.bodies, motions);
        jointRows = new JointRows(data, rows, packed, poses, states);
        contactRows = new ContactRows(motions, contacts, rows, states);
        elimination = new RowElimination(motions, rows);
        solver = new RowSolver(motions, rows, elimination, accuracy);
        NeutralRows ahead = new NeutralRows(motions, locks);
        JointRows rowsAhead = new JointRows(data, ahead, packed, poses, states);
        UnsymmetricElimination foreseen = new UnsymmetricElimination(motions, rows, elimination);
        places =
                new HeldPlaces(
                        motions,
                        rows,
                        jointRows,
                        ahead,
                        rowsAhead,
                        poses,
                        solver,
                        elimination,
                        foreseen,
                        accuracy.impactTolerance());
        recovery =
                new PlaceRecovery(
                        data.bodies,
                        motions,
                        rows,
                        jointRows,
                        poses,
                        elimination,
                        accuracy.impactTolerance());
        taut = new TautSubsteps(data);
        inertia = new TautInertia(data, motions, packed, poses);
        composed = new ComposedSubsteps(data, motions, rows, jointRows, packed, taut, accuracy);
        results = new JointResults(data, packed, rows);
        islands = data.islands;
        store = data.jointsOrNone();
        springs = new SpringSubsteps(store, rows, packed, accuracy);
        tolerance = accuracy.impactTolerance();
        crowd =
                new CrowdSolver(
                        data,
                        motions,
                        contacts,
                        rows,
                        jointRows,
                        poses,
                        packed,
                        contactRows,
                        accuracy);
        passes = new RowPasses(rows);
        stops = new Stops(data, motions, contacts, rows, jointRows, packed, tolerance);
        strikes =
                new Strikes(
                        motions, contacts, rows, jointRows, packed, poses, states, stops, fresh);
        impacts =
                new JointImpacts(
                        data,
                        motions,
                        contacts,
                        rows,
                        jointRows,
                        contactRows,
                        packed,
                        poses,
                        states,
                        stops,
                        elimination,
                        solver,
                        results);
        mayStiffen = tolerance >= Accuracy.GAME.impactTolerance();
        substeps = accuracy.substeps();
        boolean isLimited = substeps < Accuracy.EXACT.substeps();
        worth = isLimited ? WORTH : WORTH_IF_EXACT;
    }

    /** Whether an island is too large for its contacts and limits to be eliminated. */
    public boolean areCrowd(int island) {
        int contactCount = islands.pairStart[island + 1] - islands.pairStart[island];
        int jointCount = islands.jointStart[island + 1] - islands.jointStart[island];
        int bounded = LEAST_ROWS * contactCount;
        for (int i = islands.jointStart[island]; i < islands.jointStart[island + 1]; i++) {
            int slot = islands.joints[i];
            boolean isLimited =
                    store.lower[slot] > Double.NEGATIVE_INFINITY
                            || store.upper[slot] < Double.POSITIVE_INFINITY;
            bounded += (isLimited ? 1 : 0) + (store.motorMost[slot] > 0 ? 1 : 0);
        }
        boolean areMany = LEAST_ROWS * (contactCount + jointCount) > MOST_ROWS;
        return contactCount > 0 && (areMany || bounded > MOST_BOUNDED);
    }

    /**
     * How many substeps an island needs for a step of dt seconds, usually as usual; so many as well
     * where it is too taut for any.
     */
    public int substepsFor(int island, double dt, int usual) {
        isTaut = mayStiffen && taut.isBeyond(island, dt, usual);
        return isTaut ? usual : taut.count(island, dt, usual);
    }

    /** How many substeps the springs of the packed island need for a step of dt seconds. */
    public int substepsForSprings(double dt, int usual) {
        return springs.count(dt, usual);
    }

    /**
     * How many substeps of the fourth order the packed island needs for a step of dt seconds, which
     * is given so many at most; where something touches, it gets them all.
     */
    public int composedSubsteps(int island, double dt, int most) {
        return contactRows.areAny() ? most : composed.count(island, dt, most);
    }

    /**
     * How many substeps that are not composed the packed island needs, at least so many; as many as
     * there may be where it needs more, or is not eliminated as a whole.
     */
    public int plainSubsteps(int island, double dt, int least, int most) {
        return isWhole ? composed.countPlainly(island, dt, least, most) : most;
    }

    /** Whether the island that was asked for last is too taut for any number of substeps. */
    public boolean isTaut() {
        return isTaut;
    }

    /** Begins substeps of h seconds of the packed island. */
    public void beginSubsteps(double h) {
        stops.begin(h);
    }

    /** Begins with the joints of an island whose bodies and contacts are packed. */
    public void pack(int island, double firstKick, int substepsOfIsland) {
        boolean areMany = areCrowd(island);
        packed.pack(island, firstKick);
        inertia.begin();
        isTaut &= !areMany;
        strikes.watchNothing();
        stops.begin(2 * firstKick);
        places.begin();
        writeAtRest(firstKick, 2 * firstKick);
        haveStops = contactRows.areAny();
        areWritten = !haveStops;
        for (int row = 0; row < rows.count; row++) {
            haveStops |= stops.isStop(row);
        }
        contactRows.write(2 * firstKick, 0);
        isSmall = rows.count <= FEW_ROWS;
        mostStrikes = isSmall ? STRUCK_ROWS / Math.max(1, rows.count) : 0;
        double one = isTiny(substepsOfIsland) ? 0 : elimination.workOfAll();
        isWhole = !areMany && one <= worth;
        double eliminations = ELIMINATIONS * one * substepsOfIsland;
        double least = isSmall ? LEAST_WORTH : 0;
        double most = Math.min(LARGEST_ELIMINATIONS * worth, Math.max(least, eliminations));
        elimination.beginIsland(most);
        passes.begin();
        crowd.beginIsland(substeps, substepsOfIsland);
        int affordable = SOLVES / (substepsOfIsland * Math.max(1, rows.count));
        mostPasses = Math.max(LEAST_PASSES, Math.min(PASSES_PER_SUBSTEP * substeps, affordable));
        kicked = firstKick;
    }

    /**
     * Whether the packed island is worth more than all of its eliminations could take, however its
     * rows are ordered: then that need not be known.
     */
    private boolean isTiny(int substepsOfIsland) {
        double n = rows.count;
        double most = n * (n + 1) * (2 * n + 1) / 12;
        return isSmall && ELIMINATIONS * most * substepsOfIsland <= LEAST_WORTH;
    }

    /** Multiplications that eliminations of the packed island took. */
    public double multiplications() {
        return elimination.work() + crowd.takeWork();
    }

    /** Rows of the packed island that passes solved, each as often as they did. */
    public long rowSolves() {
        return passes.solves() + crowd.takeSolves();
    }

    /** How the packed island is solved. */
    public SolveMethod method() {
        return isWhole ? SolveMethod.ELIMINATION : SolveMethod.PASSES;
    }

    /** Whether the packed island is eliminated, not passed over. */
    public boolean isWhole() {
        return isWhole && !elimination.isSpent();
    }

    /**
     * Whether the packed joints hold by equations, soft springs and stops alone in substeps of h
     * seconds: no motor drives.
     */
    public boolean areHeldByEquations(double h) {
        poses.take(0);
        writeRows(h, h);
        areWritten = !contactRows.areAny();
        boolean areEquations = isWhole && !jointRows.areAnyStiff();
        for (int row = 0; areEquations && row < rows.count; row++) {
            areEquations =
                    rows.isEquation(row) || rows.lower[row] == rows.upper[row] || stops.isStop(row);
        }
        return areEquations;
    }

    /**
     * How many parts of a substep of the packed island may end early: as many as its size allows,
     * none in a crowd, whose stops are solved as they are reached.
     */
    public int mostStrikes() {
        return mostStrikes;
    }

    /**
     * Whether the packed island is so small that its impacts are at their time; then its contacts
     * are followed from substep to substep as well.
     */
    public boolean areImpactsTimed() {
        return isWhole && isSmall;
    }

    /** Whether there is anything that only pushes: a limit, a rope, a contact. */
    public boolean haveStops() {
        return haveStops;
    }

    /**
     * Looks for what strikes in a part of h seconds, before its kick; the last one was so many
     * seconds long, and velocities are those of its middle or of now.
     */
    public void findStrikes(
            double h, double lastKick, int substep, boolean areOfNow, boolean isComposed) {
        strikes.watchNothing();
        if (!areWritten) {
            poses.take(0);
            writeRows(h, h);
            contactRows.write(h, substep);
        }
        areWritten = false;
        jointRows.measureAnew();
        stops.ask(lastKick);
        strikes.find(h, areOfNow, isComposed);
    }

    /** Whether a stop that is held would have to be pulled at, by the last kick. */
    public boolean isAnyPulled() {
        for (int row = 0; states.areAny && row < rows.count; row++) {
            int joint = rows.joint[row];
            if (joint != NeutralRows.NONE
                    && states.ofJoint(joint, rows.part[row]) == RowStates.HELD
                    && rows.impulse[row] < 0) {
                return true;
            }
        }
        return false;
    }

    /** Keeps what joints carried, to be gone back to. */
    public void keep() {
        packed.keep();
        keptKick = kicked;
    }

    /** Goes back to what was kept last. */
    public void recall() {
        packed.recall();
        kicked = keptKick;
    }

    /**
     * Writes the rows of the joints where bodies are now, before a kick of so many seconds after
     * which they drift for h.
     */
    public void write(double kick, double h) {
        write(kick, h, isWhole);
    }

    /** Writes them likewise before a kick after which nothing drifts. */
    public void writeAtRest(double kick, double h) {
        write(kick, h, false);
    }

    /** Writes them; what is too taut answers by inertia where it may. */
    private void write(double kick, double h, boolean mayAnswer) {
        share = kicked == 0 ? 0 : kick / kicked;
        poses.take(0);
        if (isTaut && mayAnswer && kicked > 0) {
            inertia.stiffen(kicked, h);
        } else if (isTaut) {
            inertia.release();
        }
        kicked = kick;
        writeRows(kick, h);
        results.keepArms(poses);
    }

    /** Writes them for the poses that were taken. */
    private void writeRows(double kick, double h) {
        areWritten = false;
        rows.clear();
        jointRows.write(kick, h);
    }

    /** Begins a part of h seconds whose rows are written, before its kick. */
    public void begin(double h) {
        before = motions.fastest();
        isWhole &= !elimination.isSpent();
        if (!isWhole) {
            crowd.begin(h, share);
        }
    }

    /** Notes how bodies move after the kick, before they get what contacts carried. */
    public void takeFree() {
        if (!isWhole) {
            crowd.takeFree();
        }
    }

    /**
     * Solves joints and contacts after the kick, so that places are held at the end of a drift of h
     * seconds.
     */
    public void solve(double h, int substep, double fastest, double noise) {
        if (!isWhole) {
            crowd.solve(h, substep, fastest, noise);
            crowd.holdPlaces(h);
            results.add();
            return;
        }
        contactRows.write(h, substep);
        double settled = settled(fastest);
        work.begin();
        solver.beginAsBefore(packed, share);
        boolean isSolved = solver.solve(settled);
        if (isTaut) {
            // Kicks along the rows of the start would tremble against what inertia has answered.
            places.leave();
        } else {
            places.hold(h, settled, contactRows.carry(), isSmall);
        }
        boolean isGained = gains(noise);
        if (isGained && !contactRows.areAny()) {
            places.release();
        }
        secure(isSolved && !isGained, settled);
        finish();
    }

    /**
     * What could not be solved, or would do work, is solved by passes from nothing on, which never
     * do, and then held by the joints.
     */
    private void secure(boolean isSolved, double settled) {
        boolean mayDoWork = contactRows.areAny() || elimination.isSpent();
        if (mayDoWork && !(isSolved && done() <= MOST_WORK * energy())) {
            work.takeBack();
            work.rest();
            passes.run(mostPasses, settled);
            solver.holdEquations();
        }
    }

    /** Whether what holds places has done more work than turning takes and gives in a kick. */
    private boolean gains(double noise) {
        double share = places.areHeld() ? MOST_WORK_OF_TURNING : MOST_WORK_IF_MISSED;
        return !(work.sum() <= share * (energy() + noise));
    }

    /** J that rows have done which may do no work. */
    private double done() {
        return isSmall ? Math.min(work.sum(), work.sumOfStops()) : work.sum();
    }

    /** Speed that may be left unsolved, m/s, where the fastest body goes so fast after a kick. */
    private double settled(double fastest) {
        boolean isSlow = before < HARDLY * fastest;
        return (isSlow ? FINER : 1) * SETTLED * tolerance * fastest;
    }

    private double energy() {
        return motions.energy(motions.data);
    }

    /** Solves them at the end of the last kick, after which nothing drifts. */
    public void solveAtRest(double h, int substep, double fastest, double noise) {
        for (int row = 0; row < rows.count; row++) {
            if (rows.holdsPlace[row] && !rows.isEquation(row)) {
                // What carried a load carries on, whatever gap of round-off is left.
                rows.target[row] = stops.load(row) > 0 ? 0 : -Math.max(0, rows.place[row]) / h;
            }
        }
        if (!isWhole) {
            crowd.solve(h, substep, fastest, noise);
            results.add();
            return;
        }
        contactRows.write(h, substep);
        double settled = settled(fastest);
        work.begin();
        solver.beginAsBefore(packed, share);
        boolean isSolved = solver.solve(settled);
        secure(isSolved && work.sum() <= MOST_WORK_IF_MISSED * (energy() + noise), settled);
        finish();
    }

    private void finish() {
        contactRows.store();
        results.add();
    }

    /** Whether overlap is taken back with what joints are off their places. */
    public boolean takesOverlapBack() {
        return !isWhole;
    }

    /** Takes back what joints are off their places, by moving bodies, in a substep of h seconds. */
    public void correct(double h) {
        if (!isWhole) {
            crowd.correctOverlap(h);
            return;
        }
        recovery.correct(h);
    }

    /** Tells what joints gave their bodies in a step of dt seconds. */
    public void tell(double dt) {
        results.tell(dt);
    }

    /** Stores what joints carried in the last kick, which was so many seconds long. */
    public void store(double lastKick) {
        results.store(lastKick);
    }
}
