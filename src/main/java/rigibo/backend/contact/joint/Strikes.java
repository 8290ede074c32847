package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.FreshRows;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

import java.util.Arrays;

/**
 * Watches the stops of an island in a part of a substep: finds those that close fast, leaves them
 * out of what is solved, and tells when the first of them would be reached.
 */
public final class Strikes {

    /** No stop is reached. */
    public static final double NEVER = Double.POSITIVE_INFINITY;

    /** How many times the way that it would go a stop is looked for. */
    private static final double AHEAD = 2;

    /** Share of the least approach of a strike from which on a stop is watched. */
    private static final double WATCHED = 0.5;

    /** Share of the tolerance within which a stop counts as reached. */
    private static final double REACHED = 1e-3;

    /** Share of its tolerances in which a contact is measured for itself. */
    private static final double NEAR_WIDTH = 0.1;

    private final Motions motions;
    private final PackedContacts contacts;
    private final NeutralRows rows;
    private final JointRows jointRows;
    private final PackedJoints packed;
    private final Poses poses;
    private final RowStates states;
    private final Stops stops;
    private final FreshRows fresh;

    /** The stops that are watched: their rows, what these are of, and how far they were, m. */
    private int count;

    private int[] row = new int[16];
    private int[] joint = new int[16];
    private int[] contact = new int[16];
    private int[] part = new int[16];
    private double[] gap = new double[16];
    private double[] least = new double[16];
    private double[] near = new double[16];

    /** Whether a stop that was watched would be reached slowly. */
    private boolean isAnySoft;

    private boolean isAnyStriking;
    private boolean mayBeComposed;

    Strikes(
            Motions motions,
            PackedContacts contacts,
            NeutralRows rows,
            JointRows jointRows,
            PackedJoints packed,
            Poses poses,
            RowStates states,
            Stops stops,
            FreshRows fresh) {
        this.motions = motions;
        this.contacts = contacts;
        this.rows = rows;
        this.jointRows = jointRows;
        this.packed = packed;
        this.poses = poses;
        this.states = states;
        this.stops = stops;
        this.fresh = fresh;
    }

    /** Watches nothing: all rows are solved. */
    public void watchNothing() {
        count = 0;
        isAnyStriking = false;
        states.clear(packed.count, contacts.count);
    }

    /**
     * Looks at rows that were just written, all within their bounds, for a part of h seconds, where
     * velocities are those of now or of the middle of the part before. In a part that is composed
     * every stop is watched or held.
     */
    void find(double h, boolean areVelocitiesOfNow, boolean isComposed) {
        watchNothing();
        mayBeComposed = true;
        for (int i = 0; i < rows.count; i++) {
            if (stops.isStop(i)) {
                find(i, h, areVelocitiesOfNow, isComposed);
            }
        }
    }

    private void find(int i, double h, boolean areVelocitiesOfNow, boolean isComposed) {
        double closing = -rows.speed(i);
        double limit = stops.leastApproach(i);
        double tolerance = stops.tolerance(i);
        double place = rows.place[i];
        if (place > tolerance) {
            boolean comes = closing > WATCHED * limit && place < AHEAD * h * closing;
            if (comes || isComposed) {
                watch(i, limit, tolerance);
            }
            return;
        }
        boolean isStriking = closing > limit && (areVelocitiesOfNow || stops.load(i) <= 0);
        isAnyStriking |= isStriking;
        if (isStriking || isComposed && -closing > limit) {
            watch(i, limit, tolerance);
        } else if (isComposed && rows.joint[i] != NeutralRows.NONE && stops.load(i) > 0) {
            states.setJoint(rows.joint[i], rows.part[i], RowStates.HELD);
        } else {
            mayBeComposed = false;
        }
    }

    private void watch(int i, double limit, double tolerance) {
        if (count == row.length) {
            grow();
        }
        row[count] = i;
        joint[count] = rows.joint[i];
        contact[count] = rows.contact[i];
        part[count] = rows.part[i];
        gap[count] = rows.place[i];
        least[count] = limit;
        near[count] = tolerance;
        set(count, RowStates.OPEN);
        count++;
    }

    private void grow() {
        int capacity = 2 * count;
        row = Arrays.copyOf(row, capacity);
        joint = Arrays.copyOf(joint, capacity);
        contact = Arrays.copyOf(contact, capacity);
        part = Arrays.copyOf(part, capacity);
        gap = Arrays.copyOf(gap, capacity);
        least = Arrays.copyOf(least, capacity);
        near = Arrays.copyOf(near, capacity);
    }

    private void set(int i, byte state) {
        if (joint[i] != NeutralRows.NONE) {
            states.setJoint(joint[i], part[i], state);
        } else {
            states.setContact(contact[i], part[i] - PackedContacts.IMPULSE0, state);
        }
    }

    /** Whether a row strikes its stop now. */
    public boolean areAnyNow() {
        return isAnyStriking;
    }

    /** Whether anything is watched. */
    public boolean areAny() {
        return count > 0;
    }

    /** Whether every stop was found to be open, or pressed. */
    public boolean mayBeComposed() {
        return mayBeComposed;
    }

    /**
     * After how many seconds of the part of h seconds that is over the first stop was reached,
     * {@link #NEVER} if none was. Those that were reached slowly are noted.
     */
    public double first(double h) {
        poses.take(0);
        jointRows.measureAnew();
        isAnySoft = false;
        double first = NEVER;
        for (int i = 0; i < count; i++) {
            double place = place(i);
            if (least[i] < NEVER && place < 0 && place < gap[i]) {
                double closing = (gap[i] - place) / h;
                if (closing >= least[i]) {
                    first = Math.min(first, Math.max(0, gap[i] / closing));
                } else {
                    isAnySoft = true;
                    set(i, RowStates.BOUND);
                    least[i] = NEVER;
                }
            }
        }
        return first;
    }

    /** Whether a stop was reached slowly: it is watched no longer, and has to be solved. */
    public boolean areAnySoft() {
        return isAnySoft;
    }

    private double place(int i) {
        return joint[i] != NeutralRows.NONE
                ? jointRows.place(row[i])
                : motions.gap(contacts, contact[i], point(i));
    }

    /** The point of a contact that is watched: the last one where it has one no longer. */
    private int point(int i) {
        return Math.min(contacts.points[contact[i]] - 1, part[i] - PackedContacts.IMPULSE0);
    }

    /**
     * In how many seconds the first stop will be reached from here, or was reached, by the speeds
     * of now; contacts near by are measured anew, {@code left} seconds before the step ends. 0
     * where it is reached now.
     */
    public double untilFirst(double left) {
        poses.take(0);
        jointRows.measureAnew();
        double first = NEVER;
        for (int i = 0; i < count; i++) {
            if (least[i] < NEVER) {
                first = Math.min(first, until(i, left));
            }
        }
        return first;
    }

    private double until(int i, double left) {
        double closing;
        double place;
        if (joint[i] != NeutralRows.NONE) {
            place = jointRows.place(row[i]);
            closing = -rows.speed(row[i]);
        } else {
            int point = point(i);
            place = motions.gap(contacts, contact[i], point);
            double width = contacts.data[contact[i] * PackedContacts.STRIDE + PackedContacts.WIDTH];
            if (Math.abs(place) < NEAR_WIDTH * width) {
                fresh.measure(contact[i], left);
                point = point(i);
                place = motions.gap(contacts, contact[i], point);
            }
            closing = -motions.parting(contacts, contact[i], point);
        }
        if (!(closing > 0)) {
            return NEVER;
        }
        return Math.abs(place) <= REACHED * near[i] ? 0 : place / closing;
    }
}
