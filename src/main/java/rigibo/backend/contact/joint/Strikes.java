package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.FreshRows;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

import java.util.Arrays;

/**
 * Watches the stops of an island in a part of a substep. It finds those that close fast, leaves
 * them out of the solution, and computes when the first of them is reached.
 */
public final class Strikes {

    /** No stop is reached. */
    public static final double NEVER = Double.POSITIVE_INFINITY;

    /** Distance up to which a stop is watched, as a multiple of the expected way. */
    private static final double AHEAD = 2;

    /** Share of the striking speed from which on a stop is watched. */
    private static final double WATCHED = 0.5;

    /** Share of the tolerance within which a stop counts as reached. */
    private static final double REACHED = 1e-3;

    /** Share of the tolerances within which a contact is measured by itself. */
    private static final double NEAR_WIDTH = 0.1;

    private final Motions motions;
    private final PackedContacts contacts;
    private final NeutralRows rows;
    private final JointPlaces jointPlaces;
    private final PackedJoints packed;
    private final Poses poses;
    private final RowStates states;
    private final Stops stops;
    private final FreshRows fresh;

    /** The watched stops: their rows, the joints or contacts of these, and their distances, m. */
    private int count;

    private int[] row = new int[16];
    private int[] joint = new int[16];
    private int[] contact = new int[16];
    private int[] part = new int[16];
    private double[] gap = new double[16];
    private double[] least = new double[16];
    private double[] near = new double[16];

    /** By watched stop: whether it would be reached slowly. */
    private boolean isAnySoft;

    private boolean isAnyStriking;
    private boolean mayBeComposed;

    /** Whether the part is composed, in which every stop is watched that is not held. */
    private boolean isComposed;

    Strikes(
            Motions motions,
            PackedContacts contacts,
            NeutralRows rows,
            JointPlaces jointPlaces,
            PackedJoints packed,
            Poses poses,
            RowStates states,
            Stops stops,
            FreshRows fresh) {
        this.motions = motions;
        this.contacts = contacts;
        this.rows = rows;
        this.jointPlaces = jointPlaces;
        this.packed = packed;
        this.poses = poses;
        this.states = states;
        this.stops = stops;
        this.fresh = fresh;
    }

    /** Watches nothing, so that all rows are solved. */
    public void watchNothing() {
        count = 0;
        isAnyStriking = false;
        states.clear(packed.count, contacts.count);
    }

    /**
     * Examines rows that were just written, all bound, for a part of h seconds. Velocities are
     * those of the present or of the middle of the last part. In a composed part every stop is
     * either watched or held.
     */
    void find(double h, boolean areVelocitiesOfNow, boolean isComposed) {
        watchNothing();
        mayBeComposed = true;
        this.isComposed = isComposed;
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
        add(i, rows.joint[i], rows.contact[i], rows.part[i], rows.place[i]);
        open(limit, tolerance);
    }

    private void add(int ofRow, int ofJoint, int ofContact, int ofPart, double place) {
        if (count == row.length) {
            grow();
        }
        row[count] = ofRow;
        joint[count] = ofJoint;
        contact[count] = ofContact;
        part[count] = ofPart;
        gap[count] = place;
    }

    /** Leaves the stop that was added out of the solution. */
    private void open(double limit, double tolerance) {
        least[count] = limit;
        near[count] = tolerance;
        set(count, RowStates.OPEN);
        count++;
    }

    /**
     * Watches the points that a contact has got by being measured anew. In a stage back in time a
     * row that is bound would throw its bodies apart.
     */
    private void watchNewPoints(int like) {
        int of = contact[like];
        for (int k = 0; k < contacts.points[of]; k++) {
            int point = PackedContacts.IMPULSE0 + k;
            if (!isWatched(of, point)) {
                add(row[like], NeutralRows.NONE, of, point, motions.gap(contacts, of, k));
                open(least[like], near[like]);
            }
        }
    }

    private boolean isWatched(int ofContact, int point) {
        for (int i = 0; i < count; i++) {
            if (joint[i] == NeutralRows.NONE && contact[i] == ofContact && part[i] == point) {
                return true;
            }
        }
        return false;
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

    /** Whether any row strikes its stop now. */
    public boolean areAnyNow() {
        return isAnyStriking;
    }

    /** Whether any stop is watched. */
    public boolean areAny() {
        return count > 0;
    }

    /** Whether every stop is open or pressed. */
    public boolean mayBeComposed() {
        return mayBeComposed;
    }

    /**
     * Time within the last part of h seconds at which the first stop was reached, s; {@link #NEVER}
     * if none was. Stops that were reached slowly are noted. Contacts of bodies that may have come
     * round are measured anew, {@code left} seconds before the step ends.
     */
    public double first(double h, double left) {
        poses.take(0);
        jointPlaces.measureAnew();
        isAnySoft = false;
        double first = NEVER;
        for (int i = 0; i < count; i++) {
            if (joint[i] == NeutralRows.NONE && mayBeBent(i, h)) {
                measureAnew(i, left);
            }
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

    /**
     * Whether the gap of a contact may be closed by the curvature of its bodies' motion in a part
     * of h seconds: what moves by s around a width w comes nearer than its tangent by up to s²/w.
     */
    private boolean mayBeBent(int i, double h) {
        double width = contacts.width(contact[i]);
        double[] m = motions.data;
        int a = contacts.bodyA[contact[i]];
        int b = contacts.bodyB[contact[i]];
        double x = h * (m[b + Motions.VX] - m[a + Motions.VX]);
        double y = h * (m[b + Motions.VY] - m[a + Motions.VY]);
        double way = x * x + y * y;
        double place = place(i);
        // What is passed already would be measured from behind.
        return place >= 0 && way > NEAR_WIDTH * width * width && place < way / width;
    }

    private void measureAnew(int i, double left) {
        fresh.measure(contact[i], left);
        if (isComposed) {
            watchNewPoints(i);
        }
    }

    /** Whether a stop was reached slowly; it is no longer watched, and has to be solved. */
    public boolean areAnySoft() {
        return isAnySoft;
    }

    private double place(int i) {
        return joint[i] != NeutralRows.NONE
                ? jointPlaces.of(row[i])
                : motions.gap(contacts, contact[i], point(i));
    }

    /** The watched point of a contact; its last point if that one no longer exists. */
    private int point(int i) {
        return Math.min(contacts.points[contact[i]] - 1, part[i] - PackedContacts.IMPULSE0);
    }

    /**
     * Time in s after which the first stop is reached, or negative if it was passed, by the present
     * velocities; 0 if it is reached now. Nearby contacts are measured anew, {@code left} seconds
     * before the step ends.
     */
    public double untilFirst(double left) {
        poses.take(0);
        jointPlaces.measureAnew();
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
            place = jointPlaces.of(row[i]);
            closing = -rows.speed(row[i]);
        } else {
            int point = point(i);
            place = motions.gap(contacts, contact[i], point);
            double width = contacts.width(contact[i]);
            if (Math.abs(place) < NEAR_WIDTH * width) {
                measureAnew(i, left);
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
