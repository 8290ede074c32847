package rigibo.backend.contact.row;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ImpactMode;

/** How far a contact may deviate from a straight line in a step and still count as straight. */
public final class Straightness {

    /**
     * Share of the tolerance that is allowed where bodies are few, so that what turns on keeps its
     * energy.
     */
    private static final double FINER = 1e-2;

    private final Motions motions;

    /** That of impacts, as a share of a body's width. */
    public final double tolerance;

    /**
     * Whether bodies are followed where they are few: they are if impacts are resolved in the order
     * of time.
     */
    public final boolean follows;

    public Straightness(Motions motions, Accuracy accuracy) {
        this.motions = motions;
        tolerance = accuracy.impactTolerance();
        follows = accuracy.impacts() == ImpactMode.EVENTS;
    }

    /** In the packed island, as a share of a body's width. */
    double unseen() {
        return follows && motions.areFew() ? FINER * tolerance : tolerance;
    }
}
