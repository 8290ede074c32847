package rigibo.backend.contact.bounce;

import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.DataStorage;

/**
 * Impacts within an island: resolved together with all touching contacts if the island is solved
 * whole, otherwise pair by pair.
 */
public final class IslandImpacts {

    /** Closing speed in m/s below which it is the residual of a solved row and not an impact. */
    static final double RESIDUAL = 1e-9;

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

    /** Starts a part of a substep at a time, s after the step's start. */
    public void startAt(double time) {
        notes.start = time;
    }

    /**
     * Lists the contacts of the packed island that can bounce, for substeps of h seconds; {@code
     * worth} limits the multiplications for simultaneous impacts in this step.
     */
    public void begin(double h, double worth) {
        bounces.begin(h);
        joint.begin(worth);
    }

    /** Whether a contact that carries nothing may bounce within the next h seconds. */
    public boolean mayStrike(double h, int substep) {
        return apart.mayStrike(h, substep);
    }

    /**
     * Resolves all impacts that fall into a substep of h seconds of a pile that is solved whole.
     *
     * @return whether the rest of the step's budget was enough
     */
    public boolean resolveJointly(double h, int substep) {
        return joint.resolve(h, substep);
    }

    /**
     * Resolves impacts at the present velocities, within h seconds that count as no time.
     *
     * @return whether the rest of the step's budget was enough
     */
    public boolean resolveAtOnce(double h, int substep) {
        return joint.resolveAtOnce(h, substep);
    }

    /** Resolves all impacts that fall into a substep of h seconds, one after the other. */
    public void resolveApart(double h, int substep) {
        apart.resolve(h, substep);
    }

    /** In the last kick of a step, leaves out contacts that will bounce in the next step. */
    public void leaveOpen(int substep) {
        apart.leaveOpen(substep);
    }
}
