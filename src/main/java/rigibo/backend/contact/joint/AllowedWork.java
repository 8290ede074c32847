package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

/** How much work an island's solver may appear to do in rows that can do none. */
final class AllowedWork {

    /** Most work of equations in a kick whose places are held, as a share of the energy. */
    private static final double MOST_OF_TURNING = 0.1;

    /** Most such work where contacts carry as well, as a share of the energy. */
    private static final double LITTLE = 1e-2;

    /**
     * Most such work if Newton's method does not reach the places, which turning does not explain.
     */
    private static final double MOST_IF_MISSED = 1e-4;

    /** Most work of brakes that are not solved, as a share of the energy. */
    private static final double MOST_OF_BRAKES = 0.1;

    private final Motions motions;
    private final RowWork work;

    AllowedWork(Motions motions, RowWork work) {
        this.motions = motions;
        this.work = work;
    }

    /**
     * Whether rows did more work than turning takes and gives in a kick, with their places held or
     * missed; {@code noise} is an energy in J that does not count.
     */
    boolean isExceeded(boolean areHeld, double noise) {
        double share = areHeld ? MOST_OF_TURNING : MOST_IF_MISSED;
        return !(work.sum() <= share * (energy() + noise));
    }

    /**
     * Whether contacts did no work but round-off. Joints may do a little: what turns in the drift
     * after a kick takes it back in the next one.
     */
    boolean isNone() {
        boolean isLittle = work.sum() <= LITTLE * energy();
        double done = isLittle ? Math.min(work.sum(), work.sumOfContactsNow()) : work.sum();
        return done <= RowWork.ROUND_OFF * energy() && work.isAllOfRows();
    }

    /**
     * Whether bodies gained energy that no row gave them or, where rows are not solved, much that
     * brakes gave them.
     */
    boolean isAnyDriven(boolean isSolved) {
        boolean areBraked = isSolved || work.sumOfBrakes() <= MOST_OF_BRAKES * energy();
        return !areBraked || !work.isAllOfRows();
    }

    private double energy() {
        return motions.energy(motions.data);
    }
}
