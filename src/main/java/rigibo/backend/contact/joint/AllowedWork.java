package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

/** How much work rows may be found to have done that may do none. */
final class AllowedWork {

    /** Work of contacts and equations that is round-off, as a share of the energy of motion. */
    private static final double ROUND_OFF = 1e-6;

    /** Most work of equations in a kick whose places are held, as a share of the energy. */
    private static final double MOST_OF_TURNING = 0.1;

    /** Most work where Newton's steps do not reach the places: turning does not explain it. */
    private static final double MOST_IF_MISSED = 1e-4;

    private final Motions motions;
    private final RowWork work;

    AllowedWork(Motions motions, RowWork work) {
        this.motions = motions;
        this.work = work;
    }

    /**
     * Whether rows have done more work than turning takes and gives in a kick, where places are
     * held or missed; so much in J is noise.
     */
    boolean isExceeded(boolean areHeld, double noise) {
        double share = areHeld ? MOST_OF_TURNING : MOST_IF_MISSED;
        return !(work.sum() <= share * (energy() + noise));
    }

    /** Whether they have done none but for round-off, in an island that is small or not. */
    boolean isNone(boolean isSmall) {
        double done = isSmall ? Math.min(work.sum(), work.sumOfStops()) : work.sum();
        return done <= ROUND_OFF * energy();
    }

    private double energy() {
        return motions.energy(motions.data);
    }
}
