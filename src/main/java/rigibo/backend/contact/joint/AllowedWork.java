package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

/** Limits on the work that impulses may seem to do in rows that can do none. */
final class AllowedWork {

    /**
     * Largest work of equations in a kick after which places are held, as a share of the energy. A
     * body that would go straight by a share φ of its radius in a drift is kicked onto its circle
     * at tan(½·asin φ) times its speed, which a later kick takes back. The square of that is ¼ at
     * {@link TautSubsteps#MOST_PHASE}.
     */
    private static final double MOST_OF_TURNING = 0.26;

    /**
     * Largest such work if contacts carry load as well and nothing turns fast, as a share of the
     * energy.
     */
    private static final double LITTLE = 1e-2;

    /**
     * Largest such work if Newton's method misses the places, as a share of the energy. The turning
     * of rows explains no more.
     */
    private static final double MOST_IF_MISSED = 1e-4;

    /** Largest work of brakes that are not solved, as a share of the energy. */
    private static final double MOST_OF_BRAKES = 0.1;

    private final Motions motions;
    private final RowWork work;

    /** Work that the turning of rows explains if contacts carry load, as a share of the energy. */
    private double explained;

    AllowedWork(Motions motions, RowWork work) {
        this.motions = motions;
        this.work = work;
    }

    /** Begins a kick before a drift in which joints turn by an angle, rad. */
    void begin(double turned) {
        double share = turned / TautSubsteps.MOST_PHASE;
        explained = Math.max(LITTLE, MOST_OF_TURNING * Math.min(1, share * share));
    }

    /** Share of the energy that the turning of rows explains as work if contacts carry load. */
    double explained() {
        return explained;
    }

    /**
     * Whether rows did more work in a kick than their turning explains.
     *
     * @param areHeld whether places are held at the end of the drift
     * @param noise energy that does not count, J
     */
    boolean isExceeded(boolean areHeld, double noise) {
        double share = areHeld ? MOST_OF_TURNING : MOST_IF_MISSED;
        return !(work.sum() <= share * (energy() + noise));
    }

    /**
     * Whether the work of contacts is round-off. Joints may do what their turning explains: rows
     * that turn in the drift after a kick take it back in the next kick.
     */
    boolean isNone() {
        boolean isExplained = work.sum() <= explained * energy();
        double done = isExplained ? Math.min(work.sum(), work.sumOfContactsNow()) : work.sum();
        return done <= RowWork.ENERGY_ROUND_OFF * energy() && work.isAllOfRows();
    }

    /**
     * Whether bodies gained energy that no row gave them; if rows are not solved, also whether
     * brakes added much energy.
     */
    boolean isAnyDriven(boolean isSolved) {
        boolean areBraked = isSolved || work.sumOfBrakes() <= MOST_OF_BRAKES * energy();
        return !areBraked || !work.isAllOfRows();
    }

    private double energy() {
        return motions.energy(motions.data);
    }
}
