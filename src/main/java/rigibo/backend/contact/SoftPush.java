package rigibo.backend.contact;

/**
 * How a large pile takes overlap back: as by a spring so strongly damped that it cannot overshoot,
 * after the soft-step solvers (Catto, "Solver2D", 2024). With ω = 2πf, a₁ = 2ζ + hω and a₂ = hω·a₁
 * an overlap shrinks at the rate ω/a₁, and an impulse is drawn towards a rest by the share 1/(1 +
 * a₂), which damps what one pass over a large pile leaves unsolved.
 *
 * <p>Unlike there, that rest is not 0 but the load the contact carried of late: drawn towards 0, a
 * pile sinks until the overlap's spring carries it.
 */
final class SoftPush {

    /** Of the critical damping: the overlap creeps back without a trace of oscillation. */
    private static final double DAMPING = 10;

    /** Highest frequency in Hz, and as a share of the substeps' own. */
    private static final double MOST_HERTZ = 60;

    private static final double SHARE_OF_SUBSTEPS = 1.0 / 8;

    private final boolean isRigid;
    private double rate;
    private double share = 1;
    private double kick;

    SoftPush() {
        this(false);
    }

    private SoftPush(boolean isRigid) {
        this.isRigid = isRigid;
    }

    /** A push that leaves overlap and impulses as they are. */
    static SoftPush none() {
        return new SoftPush(true);
    }

    /** Begins a pass in a substep of h seconds whose kick is as long as is said, s. */
    void begin(double h, double kickLength) {
        double omega = 2 * Math.PI * Math.min(MOST_HERTZ, SHARE_OF_SUBSTEPS / h);
        double a1 = 2 * DAMPING + h * omega;
        double a2 = h * omega * a1;
        rate = omega / a1;
        share = a2 / (1 + a2);
        kick = kickLength;
    }

    /**
     * What is added to the speed of a point of bodies of a width, m/s: a gap may close, an overlap
     * is taken back.
     */
    double bias(double gap, double width, double perSubstep) {
        double most = OverlapSolver.MOST_PUSH * width;
        double push = gap * (gap > 0 ? perSubstep : rate);
        return push < -most ? -most : push;
    }

    /** The impulse in N·s drawn towards the load in N. */
    double soften(double impulse, double load) {
        return isRigid ? impulse : share * impulse + (1 - share) * load * kick;
    }
}
