package rigibo.backend.contact.hold;

import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.solve.OverlapSolver;
import rigibo.backend.storage.Bodies;

/**
 * Tells whether an island rests: contacts cancelled the first half of a kick, and nothing changes
 * in the rest of the step, so that other substeps would find the same.
 */
final class Stillness {

    /** Share of its width that a body at rest may move by in a step. */
    static final double STILL = 1e-9;

    /** How many times what counts as solved a body at rest may go at. */
    static final double QUIET = 16;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;

    /** Null where overlap is not taken back. */
    private final OverlapSolver overlap;

    private final Kick kick;

    Stillness(
            Bodies bodies,
            Motions motions,
            PackedContacts contacts,
            OverlapSolver overlap,
            Kick kick) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
        this.overlap = overlap;
        this.kick = kick;
    }

    /**
     * Whether the packed island does, after the first of some substeps of h seconds that began at a
     * time in s after the step's start and was solved but for {@code settled} m/s.
     */
    boolean isAtRest(double start, double h, int substeps, double settled) {
        double length = substeps * h;
        double quiet = QUIET * settled;
        return contacts.lastJoining == PackedContacts.ALWAYS
                && !motions.isAnyDriven
                && !contacts.isAnyRunning
                && isEveryBodyStill(length, quiet)
                && !(overlap != null && overlap.isAnyWanted(STILL, length, 0))
                && kick.isSteady(start + h, h, substeps - 1, quiet / length);
    }

    /**
     * Whether no body would move within so many seconds at the highest speed that is neglected,
     * m/s.
     */
    boolean isEveryBodyStill(double length, double quiet) {
        double[] m = motions.data;
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            int at = entry * Motions.STRIDE;
            double straight = Math.max(Math.abs(m[at + Motions.VX]), Math.abs(m[at + Motions.VY]));
            double turning = bodies.boundingRadius[slot] * Math.abs(m[at + Motions.SPIN]);
            double still = Math.max(quiet, STILL * bodies.smallestWidth[slot] / length);
            if (!(straight + turning <= still)) {
                return false;
            }
        }
        return true;
    }
}
