package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Effort;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.DataStorage;

/**
 * The number of substeps that an island with joints needs for a step: by its tension, by its
 * springs and, if it is free or damped, by its fastest motion.
 */
public final class JointSubsteps {

    /**
     * Share of the motion of an island too taut that is kept in a kick if nothing touches. The rest
     * is damped, so that vibrations decay. If something touches, all is damped: the pull of what is
     * struck changes from kick to kick, and an added mass would change with it, and add energy.
     */
    private static final double KEPT = 0.9;

    /**
     * Factor by which substeps have to be too few in an island in which something touches, of which
     * all motion would be damped instead.
     */
    private static final double FAR_MORE_IF_TOUCHED = 3;

    /**
     * How much faster an island vibrates than it turns, at most, if the pull of what turns explains
     * it: the inmost of three bars in a row seven times as fast.
     */
    private static final double BY_TURNING = 8;

    /**
     * Factor on the number of parts that turning needs if they are composed. The error of their
     * rate goes with its fourth power: 3·10⁻⁴ with the usual one, a millionth with that of EXACT.
     */
    private static final double FINER_IF_COMPOSED = 1.6;

    private static final double FINER_IF_EXACT = 7;

    private final TautSubsteps taut;
    private final TurningRate turning;
    private final ComposedSubsteps moving;
    private final SpringSubsteps springs;
    private final ContactRows contactRows;
    private final JointBudget budget;

    private final boolean isExact;

    /**
     * Whether an island of which many substeps would be worth following may stand still instead, at
     * this accuracy.
     */
    private final boolean mayStandStill;

    /** Whether the island vibrates faster than its substeps follow. */
    private boolean isTaut;

    /** Number of substeps that would follow it. */
    private double wanted;

    /**
     * Whether it does so without a load that explains it, unlike an island in which a limit was
     * struck.
     */
    private boolean isWedged;

    /** Whether anything touches in it, or may touch. */
    private boolean isTouched;

    /** Sum of the forces on its bodies, N; 0 if its substeps follow it. */
    private double loads;

    JointSubsteps(
            DataStorage data,
            Motions motions,
            NeutralRows rows,
            JointPlaces jointPlaces,
            PackedJoints packed,
            ContactRows contactRows,
            JointBudget budget,
            Accuracy accuracy) {
        taut = new TautSubsteps(data, accuracy);
        turning = new TurningRate(data, motions, packed);
        moving = new ComposedSubsteps(data, motions, rows, jointPlaces, packed, taut, accuracy);
        springs = new SpringSubsteps(data.jointsOrNone(), rows, packed, accuracy);
        this.contactRows = contactRows;
        this.budget = budget;
        isExact = Effort.isExact(accuracy);
        mayStandStill = accuracy.impactTolerance() >= Accuracy.FINE.impactTolerance();
    }

    /**
     * Number of substeps of an island for a step of dt seconds: at least the usual one, and no more
     * than that if the island is too taut for the number that is worth it.
     *
     * @param finest number of substeps that its turning needed in an attempt at the step
     * @param contactForce mean force of its contacts in that attempt, N
     */
    public int of(int island, double dt, int usual, double finest, double contactForce) {
        wanted = taut.wanted(island, dt);
        boolean isFast = mayStandStill && wanted > usual;
        boolean isTurning = isFast && isByTurning(island, dt, finest);
        loads = isFast ? taut.loads(island) : 0;
        isWedged = isFast && taut.isUnexplained(island, loads, contactForce);
        isTouched = taut.meetsOthers(island);
        isTaut =
                isWedged
                        || taut.isBeyondAny(island, wanted, usual)
                        || mayStandStill && !isTurning && taut.isBeyond(island, wanted, usual);
        return standsStill() ? usual : taut.count(island, wanted, usual, isTurning);
    }

    /** Whether the pull of what turns explains how fast an island vibrates. */
    private boolean isByTurning(int island, double dt, double finest) {
        double turns = Math.max(finest, parts(turning.ofStored(island), dt));
        return wanted <= BY_TURNING * turns;
    }

    /** How fast bodies of the packed island turn about their joints, rad/s. */
    public double turning() {
        return turning.ofPacked();
    }

    /**
     * Number of parts, not rounded, into which h seconds are to be divided so that nothing that
     * turns at a rate in rad/s turns too far in one.
     */
    public static double parts(double rate, double h) {
        return rate * h / TautSubsteps.MOST_PHASE;
    }

    /** Factor on that number if the parts are composed. */
    public double finerIfComposed() {
        return isExact ? FINER_IF_EXACT : FINER_IF_COMPOSED;
    }

    /** Whether bodies of an island are light compared with their load. */
    boolean isTight(int island, double dt) {
        return taut.isTight(island, dt);
    }

    /** Number of substeps that the springs of the packed island need for a step of dt seconds. */
    public int forSprings(double dt, int usual) {
        return springs.count(dt, usual);
    }

    /**
     * Number of fourth-order substeps that the packed island needs for a step of dt seconds: at
     * most {@code most}, and that number if anything touches.
     */
    public int composed(int island, double dt, int most) {
        return contactRows.areAny() ? most : moving.count(island, dt, most);
    }

    /**
     * Number of plain substeps that the packed island needs, from {@code least} to {@code most};
     * {@code most} if it is not eliminated as a whole.
     */
    public int plain(int island, double dt, int least, int most) {
        return budget.isWhole() ? moving.countPlainly(island, dt, least, most) : most;
    }

    /** Whether the last island gets few substeps, since it is too taut. */
    public boolean standsStill() {
        return isTaut && mayStandStill;
    }

    /** Whether the last island is too taut for its substeps. */
    public boolean isTaut() {
        return isTaut;
    }

    /**
     * Whether it is so taut that its damped motion is truer than what a number of substeps found.
     */
    public boolean isTautFor(int substeps) {
        boolean isFarMore = wanted > FAR_MORE_IF_TOUCHED * substeps;
        return isTaut && (isWedged || !isTouched || isFarMore);
    }

    /** Whether it is too taut, and no load explains that. */
    public boolean isWedged() {
        return isTaut && isWedged;
    }

    /**
     * Share of the motion of the last island that is kept in a kick if it is too taut: none if no
     * load explains that, or if something touches.
     */
    double kept() {
        return isWedged || isTouched ? 0 : KEPT;
    }

    /** Sum of the forces on the bodies of a wedged island, N. */
    double loads() {
        return loads;
    }

    /** Begins a packed island; a crowd is solved in passes, however taut it is. */
    void begin(boolean areMany) {
        isTaut &= !areMany;
    }
}
