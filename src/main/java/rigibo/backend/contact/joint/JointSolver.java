package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.FreshRows;
import rigibo.backend.contact.row.LockedAxes;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.SolveMethod;
import rigibo.backend.storage.DataStorage;

/**
 * Solves the joints of an island with its contacts, substep by substep. Velocities in the middle of
 * a substep are such that joints hold their places at its end (SHAKE: J.-P. Ryckaert, G. Ciccotti
 * and H. Berendsen, Numerical integration of the Cartesian equations of motion of a system with
 * constraints, 1977). After the last kick, velocities comply with the joints (H. C. Andersen,
 * Rattle, 1983). Both are symmetric in time and symplectic, so that a swing keeps its energy.
 *
 * <p>It packs the island and writes its rows; {@link WholeSolver} solves small islands, {@link
 * CrowdSolver} large ones.
 */
public final class JointSolver {

    /**
     * Factor on the residual that counts as solved if bodies hardly move before a kick: what rows
     * give way by adds up along a chain, and would keep it from resting.
     */
    private static final double FINER = 1e-3;

    /** Largest speed before a kick that is hardly any, as a share of that after it. */
    private static final double HARDLY = 1e-3;

    /** The stops of the packed island. */
    private final Stops stops;

    /** The number of substeps that islands need. */
    public final JointSubsteps needed;

    public final Strikes strikes;
    public final JointImpacts impacts;
    private final RowStates states = new RowStates();

    private final NeutralRows rows;
    private final PackedJoints packed;
    private final Poses poses;
    private final JointRows jointRows;
    private final ContactRows contactRows;
    private final RowElimination elimination;
    private final JointResults results;
    private final KickForces forces;
    private final Motions motions;
    private final WholeSolver whole;
    private final CrowdSolver crowd;

    /** Axes along which bodies are kept from moving, or null where none is locked. */
    public final LockedAxes locks;

    /** What removes overlap in islands with locked axes, or null if none is locked. */
    public final RowOverlap lockedOverlap;

    private final int substeps;
    private final JointBudget budget;

    /** Whether the packed island has anything that only pushes. */
    private boolean haveStops;

    /** Whether the rows are written for the present poses, and the island has no contacts. */
    private boolean areWritten;

    /** Length of the last kick, s, and length of the present one as a share of it. */
    private double kicked;

    private double share;

    /** The fastest speed before the present kick, m/s. */
    private double before;

    /** Length of the last kick in the stored state, s. */
    private double keptKick;

    private final TautInertia inertia;
    private final TautLines lines;
    private final double tolerance;

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
        packed = new PackedJoints(data, builder);
        poses = new Poses(data.bodies, motions);
        lines = new TautLines(packed);
        jointRows = new JointRows(data, rows, packed, poses, states, lines);
        contactRows = new ContactRows(motions, contacts, rows, states);
        elimination = new RowElimination(motions, rows);
        RowSolver solver = new RowSolver(motions, rows, elimination, accuracy);
        inertia = new TautInertia(data, motions, packed, poses, lines);
        results = new JointResults(data, packed, rows);
        forces = new KickForces(data.jointsOrNone(), packed);
        budget = new JointBudget(data, rows, elimination, accuracy);
        JointPlaces places = jointRows.places;
        needed =
                new JointSubsteps(
                        data, motions, rows, places, packed, contactRows, budget, accuracy);
        NeutralRows ahead = new NeutralRows(motions, locks);
        HeldPlaces held =
                new HeldPlaces(
                        motions,
                        rows,
                        places,
                        ahead,
                        new JointRows(data, ahead, packed, poses, states, lines),
                        poses,
                        solver,
                        elimination,
                        accuracy.impactTolerance());
        whole =
                new WholeSolver(
                        motions,
                        rows,
                        packed,
                        contactRows,
                        elimination,
                        solver,
                        held,
                        new PlaceRecovery(
                                data.bodies,
                                motions,
                                rows,
                                places,
                                poses,
                                elimination,
                                accuracy.impactTolerance()),
                        new JointedOverlap(
                                data.bodies, motions, contacts, rows, elimination, accuracy),
                        budget,
                        needed,
                        accuracy.impactTolerance());
        crowd =
                new CrowdSolver(
                        data,
                        motions,
                        contacts,
                        rows,
                        places,
                        poses,
                        packed,
                        contactRows,
                        accuracy);
        stops =
                new Stops(
                        data, motions, contacts, rows, places, packed, accuracy.impactTolerance());
        strikes = new Strikes(motions, contacts, rows, places, packed, poses, states, stops, fresh);
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
        substeps = accuracy.substeps();
        tolerance = accuracy.impactTolerance();
    }

    /** Whether an island is too large for its contacts and limits to be eliminated. */
    public boolean areCrowd(int island, double dt) {
        return budget.areMany(island)
                || budget.areManyBounded(island) && !needed.isTight(island, dt);
    }

    /** Begins substeps of h seconds of the packed island. */
    public void beginSubsteps(double h) {
        stops.begin(h);
    }

    /** Packs the joints of an island whose bodies and contacts are packed, and writes its rows. */
    public void pack(int island, double firstKick, int substepsOfIsland) {
        boolean areMany = areCrowd(island, 2 * firstKick * substepsOfIsland);
        packed.pack(island, firstKick);
        inertia.begin();
        forces.begin();
        needed.begin(areMany);
        strikes.watchNothing();
        stops.begin(2 * firstKick);
        whole.beginIsland();
        write(firstKick, 2 * firstKick, true, false);
        areWritten = !contactRows.areAny();
        haveStops = contactRows.areAny() || stops.areAny();
        contactRows.write(2 * firstKick, 0);
        budget.begin(areMany, substepsOfIsland);
        crowd.beginIsland(substeps, substepsOfIsland);
        kicked = firstKick;
    }

    /** Number of multiplications by eliminations of the packed island. */
    public double multiplications() {
        return elimination.work() + crowd.takeWork();
    }

    /** Number of row solutions by passes over the packed island. */
    public long rowSolves() {
        return whole.solves() + crowd.takeSolves();
    }

    /** The method that solves the packed island. */
    public SolveMethod method() {
        return budget.isWhole() ? SolveMethod.ELIMINATION : SolveMethod.PASSES;
    }

    /** Whether the packed island is solved by elimination, not by passes. */
    public boolean isWhole() {
        return budget.isWhole() && !elimination.isSpent();
    }

    /**
     * Whether the packed joints are equations, soft springs and stops alone in substeps of h
     * seconds: no motor drives.
     */
    public boolean areHeldByEquations(double h) {
        poses.take(0);
        writeRows(h, h, false);
        areWritten = !contactRows.areAny();
        boolean areEquations = budget.isWhole() && !jointRows.areAnyStiff();
        for (int row = 0; areEquations && row < rows.count; row++) {
            areEquations =
                    rows.isEquation(row) || rows.lower[row] == rows.upper[row] || stops.isStop(row);
        }
        return areEquations;
    }

    /**
     * Number of parts of a substep of the packed island that may end early at an impact. A large
     * island has none: its stops are solved without their times.
     */
    public int mostStrikes() {
        return budget.mostStrikes();
    }

    /**
     * Whether the impacts of the packed island are resolved at their time. Its contacts are then
     * followed from substep to substep as well.
     */
    public boolean areImpactsTimed() {
        return budget.isWhole() && budget.isSmall();
    }

    /** Whether the packed island has stops: limits, ropes or contacts. */
    public boolean haveStops() {
        return haveStops;
    }

    /**
     * Finds the stops that may be struck in a part of h seconds, before its kick.
     *
     * @param lastKick length of the last kick, s
     * @param areOfNow whether velocities are the present ones, not those of the middle of the last
     *     part
     */
    public void findStrikes(
            double h, double lastKick, int substep, boolean areOfNow, boolean isComposed) {
        strikes.watchNothing();
        if (!areWritten) {
            poses.take(0);
            writeRows(h, h, false);
            contactRows.write(h, substep);
        }
        areWritten = false;
        jointRows.places.measureAnew();
        stops.ask(lastKick);
        strikes.find(h, areOfNow, isComposed);
    }

    /** Whether a stop that is held pulled in the last kick. */
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

    /** Stores the impulses of joints, so that they can be restored. */
    public void keep() {
        packed.keep();
        keptKick = kicked;
    }

    /** Restores the stored impulses. */
    public void recall() {
        packed.recall();
        kicked = keptKick;
    }

    /**
     * Writes the rows of the joints at the present poses, before a kick of a length in s and a
     * drift of h seconds.
     */
    public void write(double kick, double h) {
        write(kick, h, false, budget.isWhole());
    }

    /** Writes the rows likewise, for a kick after which nothing drifts. */
    public void writeAtRest(double kick, double h) {
        write(kick, h, true, budget.isWhole());
    }

    /**
     * Writes the rows. If the island is solved whole, bodies under too much tension get a larger
     * inertia before they drift, and joints whose tension no load explains give way.
     */
    private void write(double kick, double h, boolean isLast, boolean isSolvedWhole) {
        share = kicked == 0 ? 0 : kick / kicked;
        poses.take(0);
        lines.rest();
        if (needed.isTaut() && isSolvedWhole && kicked > 0) {
            lines.begin(kicked, needed.kept());
            inertia.stiffen(kicked, h, needed.isWedged());
        } else if (needed.isTaut()) {
            inertia.release();
        }
        kicked = kick;
        if (isSolvedWhole && needed.isWedged()) {
            jointRows.taut.begin(needed.loads(), tolerance);
        }
        writeRows(kick, h, isLast);
        jointRows.taut.rest();
        results.keepArms(poses);
    }

    /** Writes the rows for the poses that were taken. */
    private void writeRows(double kick, double h, boolean isLast) {
        areWritten = false;
        rows.clear();
        jointRows.write(kick, h, isLast, share);
    }

    /** Begins a part of h seconds whose rows are written, before its kick. */
    public void begin(double h) {
        before = motions.fastest();
        budget.review();
        if (!budget.isWhole()) {
            crowd.begin(h, share);
        }
    }

    /** Stores velocities after the kick, before the impulses of contacts are applied. */
    public void takeFree() {
        if (!budget.isWhole()) {
            crowd.takeFree();
        }
    }

    /**
     * Solves joints and contacts after the kick, so that places are held at the end of a drift of h
     * seconds.
     */
    public void solve(double h, int substep, double fastest, double noise) {
        contactRows.write(h, substep);
        double finer = finer(fastest);
        if (budget.isWhole()) {
            whole.solve(h, share, fastest, noise, finer);
        } else {
            crowd.solve(h, before, fastest, noise, finer);
            crowd.holdPlaces(h);
        }
        forces.add(results, kicked);
    }

    /** Solves them at the end of the last kick, after which nothing drifts. */
    public void solveAtRest(double h, int substep, double fastest, double noise) {
        stops.aimAtRest(h);
        contactRows.writeAtRest(h, substep);
        double finer = finer(fastest);
        if (budget.isWhole()) {
            whole.solveAtRest(share, fastest, noise, finer);
        } else {
            crowd.solve(h, before, fastest, noise, finer);
        }
        forces.add(results, kicked);
    }

    /** Factor on the residual that counts as solved. */
    private double finer(double fastest) {
        return before < HARDLY * fastest ? FINER : 1;
    }

    /** Whether overlap is removed here. It is not in a small island where only axes are locked. */
    public boolean takesOverlapBack() {
        return !budget.isWhole() || packed.count > 0;
    }

    /** Removes overlap with joints held, after a drift of h seconds. */
    public void takeOverlapBack(double h) {
        if (budget.isWhole()) {
            whole.correctOverlap(h);
        } else {
            crowd.correctOverlap(h);
        }
    }

    /**
     * Removes the position errors of joints by moving bodies, in a substep of h seconds. A crowd
     * does so before the kick.
     */
    public void correct(double h) {
        if (budget.isWhole()) {
            whole.correctPlaces(h);
        }
    }

    /** Stores the mean forces of joints in a step of dt seconds. */
    public void tell(double dt) {
        results.tell(dt);
        forces.tellLess();
    }

    /**
     * Stores the mean forces likewise, or those of the first kick where they are greater, by which
     * the substeps that an island needs are found.
     */
    public void tellGreatest(double dt) {
        results.tell(dt);
        forces.tellGreater();
    }

    /** Stores the forces of joints in the last kick, given its length in s. */
    public void store(double lastKick) {
        results.store(lastKick);
    }
}
