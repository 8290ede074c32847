package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.DataStorage;

/**
 * How many substeps an island with joints needs for a step: by what is taut in it, by its springs,
 * and, where it is free or damped, by the fastest of its motions.
 */
public final class JointSubsteps {

    private final TautSubsteps taut;
    private final ComposedSubsteps moving;
    private final SpringSubsteps springs;
    private final ContactRows contactRows;
    private final JointBudget budget;

    /** Whether tautness may be answered by inertia at this accuracy. */
    private final boolean mayStiffen;

    /** Whether the island trembles faster than its substeps follow. */
    private boolean isTaut;

    /** Whether it is so without a load that explains it. */
    private boolean isWedged;

    JointSubsteps(
            DataStorage data,
            Motions motions,
            NeutralRows rows,
            JointRows jointRows,
            PackedJoints packed,
            ContactRows contactRows,
            JointBudget budget,
            Accuracy accuracy) {
        taut = new TautSubsteps(data);
        moving = new ComposedSubsteps(data, motions, rows, jointRows, packed, taut, accuracy);
        springs = new SpringSubsteps(data.jointsOrNone(), rows, packed, accuracy);
        this.contactRows = contactRows;
        this.budget = budget;
        mayStiffen = accuracy.impactTolerance() >= Accuracy.FINE.impactTolerance();
    }

    /**
     * How many an island needs for a step of dt seconds, usually as usual; so many as well where it
     * is too taut for any.
     */
    public int of(int island, double dt, int usual) {
        isTaut = mayStiffen && taut.isBeyond(island, dt, usual);
        isWedged = isTaut && taut.isWedged(island);
        return isTaut ? usual : taut.count(island, dt, usual);
    }

    /** How many the springs of the packed island need for a step of dt seconds. */
    public int forSprings(double dt, int usual) {
        return springs.count(dt, usual);
    }

    /**
     * How many of the fourth order the packed island needs for a step of dt seconds, which is given
     * so many at most; where something touches, it gets them all.
     */
    public int composed(int island, double dt, int most) {
        return contactRows.areAny() ? most : moving.count(island, dt, most);
    }

    /**
     * How many that are not composed the packed island needs, at least so many; as many as there
     * may be where it needs more, or is not eliminated as a whole.
     */
    public int plain(int island, double dt, int least, int most) {
        return budget.isWhole() ? moving.countPlainly(island, dt, least, most) : most;
    }

    /** Whether the island that was asked for last is too taut for any number of substeps. */
    public boolean isTaut() {
        return isTaut;
    }

    /** Whether it is, and no load explains that. */
    public boolean isWedged() {
        return isTaut && isWedged;
    }

    /** Begins an island that is packed; one of a crowd is passed over, however taut it is. */
    void begin(boolean areMany) {
        isTaut &= !areMany;
    }
}
