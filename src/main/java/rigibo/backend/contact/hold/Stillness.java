package rigibo.backend.contact.hold;

import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.OwnLoads;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.solve.OverlapSolver;
import rigibo.backend.storage.Bodies;

/**
 * Tells whether an island rests: contacts cancelled the first half of a kick, and nothing changes
 * in the rest of the step, so that other substeps would find the same. What is left of a body's
 * kick is judged by what the body itself carries, so that a weak push moves whatever nothing holds,
 * however heavy its neighbours are.
 */
final class Stillness {

    /** Share of its width that a body at rest may move by in a step. */
    static final double STILL = 1e-9;

    /**
     * Share of its own loads by which a body may be held too little or too much: what rows give way
     * by, 10⁻¹⁰ of their load, adds up from storey to storey.
     */
    static final double UNHELD = 1e-8;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;
    private final OwnLoads own;

    /** Null where overlap is not taken back. */
    private final OverlapSolver overlap;

    private final Kick kick;

    /**
     * By entry of the motions: velocities before the step's first kick, laid out as the motions.
     */
    private double[] before = new double[16 * Motions.STRIDE];

    Stillness(
            Bodies bodies,
            Motions motions,
            PackedContacts contacts,
            OwnLoads own,
            OverlapSolver overlap,
            Kick kick) {
        this.own = own;
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
        this.overlap = overlap;
        this.kick = kick;
    }

    /** Notes the velocities that the packed island begins its step with. */
    void begin() {
        int length = motions.count * Motions.STRIDE;
        if (before.length < length) {
            before = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, before, 0, length);
    }

    /**
     * Whether no body of the packed island goes faster than a share of what its own pull would give
     * it in a step of {@code dt} seconds.
     */
    boolean isEveryBodyStill(double dt, double share) {
        for (int entry = 1; entry < motions.count; entry++) {
            double quiet = share * dt * own.pull(entry);
            if (!(speed(entry, 0) <= Math.max(quiet, creep(entry, dt)))) {
                return false;
            }
        }
        return true;
    }

    /**
     * Whether the packed island rests, after the first of some substeps of h seconds that began at
     * a time in s after the step's start, and whose kick lasted {@code kicked} seconds.
     */
    boolean isAtRest(double start, double h, int substeps, double kicked) {
        double length = substeps * h;
        return contacts.lastJoining == PackedContacts.ALWAYS
                && !motions.isAnyDriven
                && !contacts.isAnyRunning
                && isEveryBodyHeld(length, kicked)
                && !(overlap != null && overlap.isAnyWanted(STILL, length, 0))
                && kick.isSteady(start + h, h, substeps - 1, Equilibrium.UNHELD * kick.strongest());
    }

    /** Whether no body would move, and none is accelerated, by what is left of its kick. */
    private boolean isEveryBodyHeld(double length, double kicked) {
        own.measure(kicked);
        for (int entry = 1; entry < motions.count; entry++) {
            double speed = speed(entry, 0);
            boolean isHeld =
                    speed <= creep(entry, length)
                            && Math.min(speed, speed(entry, 1)) <= UNHELD * own.of(entry);
            if (!isHeld) {
                return false;
            }
        }
        return true;
    }

    /**
     * Stops every body of the packed island whose kick of {@code kicked} seconds was cancelled:
     * rows give way by a share of what they carry, and a body would sink by it for as long as
     * another one keeps the island from resting.
     */
    void haltHeld(double kicked) {
        own.measure(kicked);
        for (int entry = 1; entry < motions.count; entry++) {
            double most = UNHELD * own.of(entry);
            if (speed(entry, 1) <= most && speed(entry, 0) <= most) {
                motions.halt(entry * Motions.STRIDE);
            }
        }
    }

    /** The fastest that any point of a body goes, less a multiple of how it began the step, m/s. */
    private double speed(int entry, double times) {
        double[] m = motions.data;
        int at = entry * Motions.STRIDE;
        double x = m[at + Motions.VX] - times * before[at + Motions.VX];
        double y = m[at + Motions.VY] - times * before[at + Motions.VY];
        double spin = m[at + Motions.SPIN] - times * before[at + Motions.SPIN];
        double radius = bodies.boundingRadius[motions.slots[entry]];
        return Math.max(Math.abs(x), Math.abs(y)) + radius * Math.abs(spin);
    }

    /** The speed (m/s) at which a body at rest may creep for so many seconds. */
    private double creep(int entry, double length) {
        return STILL * bodies.smallestWidth[motions.slots[entry]] / length;
    }
}
