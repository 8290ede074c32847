package rigibo.backend.contact.joint;

import rigibo.backend.contact.bounce.HitNotes;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.impact.Impact;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

/**
 * Impacts of what joints hold together, at one instant: the law of impact (see {@link
 * rigibo.backend.impact.ImpactLaw}) with the equations of all joints beside it, so that an impact
 * goes through the joints at once. The stop that closes with the most energy comes first, equals at
 * once, and with them what carries a load; then what closes by that, until nothing does. So a row
 * of bodies that only touch hands an impact on, and what stands on a floor is struck as from the
 * floor.
 */
public final class JointImpacts {

    /** Impacts of one instant; a longer chain ends without rebound. */
    private static final int MOST = 64;

    /** Share of the strongest approach from which on another one is its equal. */
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

    /** Whether the last instant had more impacts than may be, and what was left had no answer. */
    private boolean isEndless;

    /** By row: its speed before, and whether it strikes. */
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
     * Strikes all that closes fast where it is on its stop, {@code time} seconds after the step's
     * start; velocities are those of now. Returns whether there was anything.
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
     * Whether the instant that was struck last would have gone on for ever: what is wedged between
     * points that nothing makes give way is thrown from one to the other in no time.
     */
    public boolean areEndless() {
        return isEndless;
    }

    private void write(int substep) {
        states.clear(packed.count, contacts.count);
        rows.clear();
        poses.take(0);
        jointRows.measureAnew();
        jointRows.writeAtOnce();
        results.keepArms(poses);
        contactRows.write(1, substep);
        if (before.length < rows.count) {
            before = new double[rows.bodies.length];
            strikes = new boolean[rows.bodies.length];
        }
    }

    /** Chooses those that strike first; whether there are any. */
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

    /** J that a row would take to stop it, twice; 0 where it parts. */
    private double strength(int row) {
        double closing = Math.max(0, -before[row]);
        return closing * closing / rows.response[row];
    }

    /** Solves for what was chosen, with a share of the elasticity; whether there is an answer. */
    private boolean solve(double share) {
        for (int row = 0; row < rows.count; row++) {
            ask(row, share);
        }
        memory.keep();
        elimination.forget();
        solver.begin();
        boolean isSolved = solver.solve(SETTLED * motions.fastest()) && limitEnergy();
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
            // A row's surface speed foresees how outlines turn within a substep, which limitEnergy
            // would take for the work of a belt.
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

    /** Whether a row is of the other point of a contact that strikes, and touches too. */
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

    /** Scales all impulses back where they would add energy; whether they are finite. */
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
                rows.push(row, (share - 1) * rows.impulse[row]);
            }
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
