package rigibo.backend.contact.joint;

import rigibo.backend.contact.bounce.HitNotes;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.impact.Impact;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

/**
 * Simultaneous impacts in an island with joints: the law of impact (see {@link
 * rigibo.backend.impact.ImpactLaw}) together with the equations of all joints, so that an impact
 * passes through the joints at once. The stop whose impact has the most energy comes first, with
 * all equal ones and with the stops that carry a load; then those that close because of it, until
 * none does. A row of bodies that only touch thus hands an impact on, and a body on a floor is
 * struck as if it were one with the floor.
 */
public final class JointImpacts {

    /** Most impacts at one instant; a longer sequence ends without rebound. */
    private static final int MOST = 64;

    /** Share of the strongest impact from which on another one counts as equal. */
    private static final double EQUAL = 1 - 1e-6;

    /** Share of the fastest speed that counts as solved. */
    private static final double SETTLED = 1e-13;

    private final Motions motions;
    private final PackedContacts contacts;
    private final Pairs pairs;
    private final NeutralRows rows;
    private final JointRows jointRows;
    private final ContactRows contactRows;
    private final PackedJoints packed;
    private final Poses poses;
    private final RowStates states;
    private final Stops stops;
    private final RowElimination elimination;
    private final RowSolver solver;
    private final RowMemory memory;
    private final JointResults results;
    private final HitNotes notes;
    private final Impact impact = new Impact();

    /** Whether the last instant had too many impacts, and the rest had no solution. */
    private boolean isEndless;

    /** By row: its speed before the impact, and whether it strikes. */
    private double[] before = new double[64];

    private boolean[] strikes = new boolean[64];

    JointImpacts(
            DataStorage data,
            Motions motions,
            PackedContacts contacts,
            NeutralRows rows,
            JointRows jointRows,
            ContactRows contactRows,
            PackedJoints packed,
            Poses poses,
            RowStates states,
            Stops stops,
            RowElimination elimination,
            RowSolver solver,
            JointResults results) {
        this.motions = motions;
        this.contacts = contacts;
        pairs = data.pairs;
        this.rows = rows;
        this.jointRows = jointRows;
        this.contactRows = contactRows;
        this.packed = packed;
        this.poses = poses;
        this.states = states;
        this.stops = stops;
        this.elimination = elimination;
        this.solver = solver;
        this.results = results;
        memory = new RowMemory(motions, rows);
        notes = new HitNotes(data, motions, contacts);
    }

    /**
     * Resolves the impacts of all stops that are reached and close fast, {@code time} seconds after
     * the step's start, at the present velocities. Returns whether there were any.
     */
    public boolean strike(double time, int substep) {
        notes.start = time;
        write(substep);
        isEndless = false;
        boolean isAny = false;
        for (int i = 0; i < MOST && choose(); i++) {
            if (!solve(1) && !solve(0)) {
                return isAny;
            }
            isAny = true;
        }
        if (isAny && choose()) {
            chooseAll();
            isEndless = !solve(0) || choose();
        }
        return isAny;
    }

    /**
     * Whether impacts at the last instant would not have ended: a body wedged between immovable
     * points is thrown from one to the other in no time.
     */
    public boolean areEndless() {
        return isEndless;
    }

    private void write(int substep) {
        states.clear(packed.count, contacts.count);
        rows.clear();
        poses.take(0);
        jointRows.writeAtOnce();
        results.keepArms(poses);
        contactRows.write(1, substep);
        if (before.length < rows.count) {
            before = new double[rows.bodies.length];
            strikes = new boolean[rows.bodies.length];
        }
    }

    /** Chooses the impacts that come first; returns whether there are any. */
    private boolean choose() {
        double most = 0;
        for (int row = 0; row < rows.count; row++) {
            before[row] = rows.speed(row);
            if (stops.isStop(row) && closes(row)) {
                most = Math.max(most, strength(row));
            }
        }
        for (int row = 0; row < rows.count; row++) {
            strikes[row] =
                    most > 0 && stops.isStop(row) && strength(row) >= EQUAL * most && closes(row);
        }
        return most > 0;
    }

    private void chooseAll() {
        for (int row = 0; row < rows.count; row++) {
            strikes[row] = stops.isStop(row) && isOn(row);
        }
    }

    private boolean isOn(int row) {
        return rows.place[row] <= stops.tolerance(row);
    }

    private boolean closes(int row) {
        return before[row] < 0 && isOn(row) && -before[row] > stops.leastApproach(row);
    }

    /** Twice the energy that stops a row, J; 0 if it parts. */
    private double strength(int row) {
        double closing = Math.max(0, -before[row]);
        return closing * closing / rows.response[row];
    }

    /**
     * Solves the chosen impacts with a share of their elasticity; returns whether there is a
     * solution.
     */
    private boolean solve(double share) {
        for (int row = 0; row < rows.count; row++) {
            ask(row, share);
        }
        memory.keep();
        elimination.forget();
        solver.begin();
        boolean isSolved = solver.solve(SETTLED * motions.fastest());
        if (isSolved) {
            memory.redo();
            isSolved = limitEnergy();
        }
        if (isSolved) {
            tell();
        } else {
            memory.recall();
        }
        return isSolved;
    }

    private void ask(int row, double share) {
        rows.impulse[row] = 0;
        rows.give[row] = 0;
        if (stops.isStop(row)) {
            boolean isAsked = strikes[row] || isBeside(row) || isOn(row) && stops.isLoaded(row);
            boolean rebounds = isAsked && (strikes[row] || isBeside(row));
            rows.lower[row] = 0;
            rows.upper[row] = isAsked ? Double.POSITIVE_INFINITY : 0;
            rows.target[row] =
                    rebounds ? share * stops.elasticity(row) * Math.max(0, -before[row]) : 0;
        } else if (rows.joint[row] == NeutralRows.NONE
                && rows.part[row] == PackedContacts.IMPULSE_T) {
            // A row's surface speed anticipates how outlines turn within a substep, which
            // limitEnergy would take for the work of a belt.
            rows.target[row] = contacts.running[rows.contact[row]];
        } else if (rows.joint[row] == NeutralRows.NONE
                && rows.part[row] == PackedContacts.IMPULSE_R) {
            rows.load[row] = NeutralRows.NONE;
            rows.lower[row] = 0;
            rows.upper[row] = 0;
        } else if (rows.isEquation(row) && rows.holdsPlace[row]) {
            rows.target[row] = 0;
        }
    }

    /** Whether a row is the other point of a contact that strikes, and touches as well. */
    private boolean isBeside(int row) {
        int contact = rows.contact[row];
        if (contact == NeutralRows.NONE || !isOn(row)) {
            return false;
        }
        int other = rows.part[row] == PackedContacts.IMPULSE0 ? row + 1 : row - 1;
        return other >= 0
                && other < rows.count
                && rows.contact[other] == contact
                && stops.isStop(other)
                && strikes[other];
    }

    /** Scales all impulses down if they would add energy; returns whether they are finite. */
    private boolean limitEnergy() {
        double linear = 0;
        double quadratic = 0;
        for (int row = 0; row < rows.count; row++) {
            boolean isDrive = rows.joint[row] != NeutralRows.NONE && !rows.holdsPlace[row];
            double driven = rows.load[row] == NeutralRows.NONE ? 0 : rows.target[row];
            if (!isDrive) {
                double gained = rows.speed(row) - before[row];
                linear += rows.impulse[row] * (before[row] - driven);
                quadratic += rows.impulse[row] * gained / 2;
            }
        }
        if (linear + quadratic > 0) {
            double share = Math.max(0, -linear / quadratic);
            for (int row = 0; row < rows.count; row++) {
                rows.impulse[row] *= share;
            }
            // Huge impulses that were taken back would leave their round-off.
            memory.redo();
        }
        return Math.abs(linear) + Math.abs(quadratic) < Double.POSITIVE_INFINITY;
    }

    private void tell() {
        results.addImpact();
        int last = NeutralRows.NONE;
        for (int row = 0; row < rows.count; row++) {
            int contact = rows.contact[row];
            if (contact == NeutralRows.NONE || !stops.isStop(row)) {
                continue;
            }
            contacts.data[contact * PackedContacts.STRIDE + PackedContacts.TOTAL] +=
                    rows.impulse[row];
            if (strikes[row] && contact != last) {
                last = contact;
                note(row, contact);
            }
        }
    }

    private void note(int row, int contact) {
        int at = contact * PackedContacts.STRIDE;
        impact.points = 0;
        impact.normalX = contacts.data[at + PackedContacts.NX];
        impact.normalY = contacts.data[at + PackedContacts.NY];
        contacts.addPoint(contact, rows.part[row] - PackedContacts.IMPULSE0, impact);
        if (isBeside(row)) {
            contacts.addPoint(contact, 1 - (rows.part[row] - PackedContacts.IMPULSE0), impact);
        }
        notes.note(contact, impact, -before[row], 0);
        pairs.impacts[contacts.pair[contact]]++;
        contacts.impacts++;
        contacts.work.impacts++;
    }
}
