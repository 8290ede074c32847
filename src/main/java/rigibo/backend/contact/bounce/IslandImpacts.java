package rigibo.backend.contact.bounce;

import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.DataStorage;

/**
 * Impacts within an island: resolved for all contacts at once where the island is solved whole,
 * else in turn.
 */
public final class IslandImpacts {

    private final BounceRows bounces;
    private final SimultaneousImpacts joint;
    private final PairwiseImpacts apart;
    private final HitNotes notes;

    /** Impacts within a tolerance, as a share of a body's width. */
    public IslandImpacts(
            DataStorage data,
            Motions motions,
            PackedContacts contacts,
            Kick kick,
            double tolerance) {
        bounces = new BounceRows(data, contacts);
        notes = new HitNotes(data, motions, contacts);
        joint = new SimultaneousImpacts(data, motions, contacts, kick, bounces, notes, tolerance);
        apart = new PairwiseImpacts(data, motions, contacts, bounces, notes);
    }

    /** What is resolved next is in a part of a substep that begins at a time of the step, s. */
    public void startAt(double time) {
        notes.start = time;
    }

    /**
     * Lists what can bounce in the packed island, for substeps of h seconds; to answer it jointly
     * is worth so many multiplications in this step.
     */
    public void begin(double h, double worth) {
        bounces.begin(h);
        joint.begin(worth);
    }

    /**
     * Resolves all impacts that fall into a substep of h seconds of a pile that is solved whole.
     *
     * @return whether what was left of the step's work was enough for that
     */
    public boolean resolveJointly(double h, int substep) {
        return joint.resolve(h, substep);
    }

    /** Resolves impacts at the velocities as they are, within next to no time. */
    public boolean resolveAtOnce(double h, int substep) {
        return joint.resolveAtOnce(h, substep);
    }

    /** Resolves all impacts that fall into a substep of h seconds, one after the other. */
    public void resolveApart(double h, int substep) {
        apart.resolve(h, substep);
    }

    /** Leaves what is about to bounce to the next step, in the kick that ends this one. */
    public void leaveOpen(int substep) {
        apart.leaveOpen(substep);
    }
}
