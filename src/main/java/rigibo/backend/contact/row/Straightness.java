package rigibo.backend.contact.row;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ImpactMode;

/** The deviation from a straight line up to which a contact counts as straight in a step. */
public final class Straightness {

    /**
     * Share of the tolerance that is used in islands of few bodies, so that turning bodies keep
     * their energy.
     */
    private static final double FINER = 1e-2;

    private final Motions motions;

    /** The deviation, in widths. */
    public final double tolerance;

    /** Whether few bodies are followed closely: if impacts are resolved in time order. */
    public final boolean follows;

    public Straightness(Motions motions, Accuracy accuracy) {
        this.motions = motions;
        tolerance = accuracy.impactTolerance();
        follows = accuracy.impacts() == ImpactMode.EVENTS;
    }

    /** Deviation that is neglected in the packed island, in widths. */
    double unseen() {
        return follows && motions.areFew() ? FINER * tolerance : tolerance;
    }
}
