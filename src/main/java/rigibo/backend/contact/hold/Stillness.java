package rigibo.backend.contact.hold;

import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.OwnLoads;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.solve.OverlapSolver;
import rigibo.backend.storage.Bodies;

/**
 * Tests whether an island rests: contacts cancelled the first half kick, and nothing changes in the
 * rest of the step, so that further substeps would give the same result. The rest of a body's kick
 * is compared with the loads of that body alone, so that a weak push moves an unsupported body
 * however heavy its neighbours are.
 */
final class Stillness {

    /** Largest distance that a body at rest may move in a step, in widths. */
    static final double STILL = 1e-9;

    /**
     * Largest imbalance of a body as a share of its own loads: the compliance of rows, 10⁻¹⁰ of
     * their load, adds up from storey to storey.
     */
    static final double UNHELD = 1e-8;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;
    private final OwnLoads own;

    /** Removes overlap; null if it is not corrected. */
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

    /** Stores the velocities at the start of the packed island's step. */
    void begin() {
        int length = motions.count * Motions.STRIDE;
        if (before.length < length) {
            before = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, before, 0, length);
    }

    /**
     * Whether no body of the packed island is faster than a share of the speed that its own pull
     * would give it in a step of {@code dt} seconds.
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
     * Whether the packed island rests after its first substep of h seconds, which began at a time,
     * s after the step's start, and whose kick lasted {@code kicked} seconds.
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

    /** Whether the rest of its kick would neither move nor accelerate any body. */
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
     * Stops every body of the packed island whose kick of {@code kicked} seconds was cancelled.
     * Otherwise the compliance of rows would let it sink for as long as another body keeps the
     * island from resting.
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

    /** Highest speed of any point of a body, less a multiple of its velocity at the start, m/s. */
    private double speed(int entry, double times) {
        double[] m = motions.data;
        int at = entry * Motions.STRIDE;
        double x = m[at + Motions.VX] - times * before[at + Motions.VX];
        double y = m[at + Motions.VY] - times * before[at + Motions.VY];
        double spin = m[at + Motions.SPIN] - times * before[at + Motions.SPIN];
        double radius = bodies.boundingRadius[motions.slots[entry]];
        return Math.max(Math.abs(x), Math.abs(y)) + radius * Math.abs(spin);
    }

    /** Highest speed at which a body at rest may creep for a time in s, m/s. */
    private double creep(int entry, double length) {
        return STILL * bodies.smallestWidth[motions.slots[entry]] / length;
    }
}
