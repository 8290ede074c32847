package rigibo.backend.contact.row;

import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.Pairs;

/**
 * The contacts of bodies that turn fast. A row treats outlines and paths as straight lines. An
 * outline of radius R that turns by φ deviates from its line by the sagitta Rφ²/2, and by sφ more
 * if it slides by s meanwhile. If the sagitta of a step matters, the contact is measured again
 * before every substep; if that of a substep matters, the island gets more substeps and removes
 * overlap at once.
 */
public final class TurningRows {

    /**
     * Largest sum over all substeps of such deviations in an island with the usual number of
     * substeps, in widths; with n substeps the sum is 1/n of the deviation over the whole step.
     */
    private static final double CALM = 0.02;

    /** Largest turn in a substep, as a share of the turn from one face to the next. */
    private static final double MOST_OF_FACE = 0.05;

    /** Largest number of substeps, as a multiple of the usual one. */
    private static final double MOST_MORE = 16;

    /**
     * Largest such multiple times the square of the number of bodies, since one wild body in a heap
     * makes all of it cost more.
     */
    private static final double MOST_IN_ALL = 4096;

    /** Turn within a substep up to which a point's arc is treated as a parabola, rad. */
    private static final double MOST_BEND = 0.1;

    /** Most parts in which bodies drift through a substep. */
    private static final int MOST_PARTS = 8;

    /** Turn within such a part above which a contact is measured again, rad. */
    private static final double FAR = 0.5 * MOST_BEND;

    /**
     * Additional share of an overlap removed per second, 1/s, for each unit by which the multiple
     * of substeps exceeds 1: practically all of it in one substep.
     */
    private static final double AT_ONCE = 1e4;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Islands islands;
    private final Motions motions;
    private final PackedContacts contacts;
    private final FreshRows fresh;

    /** Whether any body of the packed island turns too far. */
    private boolean isAnyTurning;

    /** By entry of the motions: whether that body turns too far in the rest of the step. */
    private boolean[] turnsFar = new boolean[16];

    /** Sagitta of a whole step that is neglected, in widths. */
    private final Straightness straight;

    public TurningRows(
            DataStorage data,
            Motions motions,
            PackedContacts contacts,
            FreshRows fresh,
            Straightness straight) {
        this.straight = straight;
        bodies = data.bodies;
        pairs = data.pairs;
        islands = data.islands;
        this.motions = motions;
        this.contacts = contacts;
        this.fresh = fresh;
    }

    /**
     * Number of substeps that an island needs for the rest of a step: the usual one, unless its
     * bodies turn fast.
     */
    public int substepsFor(int island, double left, int usual) {
        double wanted = 1;
        int end = islands.bodyStart[island + 1];
        for (int i = islands.bodyStart[island]; i < end; i++) {
            int slot = islands.bodies[i];
            double missed = leaves(slot, left) / usual;
            wanted = Math.max(wanted, missed / (CALM * bodies.smallestWidth[slot]));
            if (end - islands.bodyStart[island] <= Motions.FEW) {
                wanted = Math.max(wanted, facesTurned(slot, left) / (usual * MOST_OF_FACE));
            }
        }
        double count = end - islands.bodyStart[island];
        double most = Math.min(MOST_MORE, MOST_IN_ALL / (count * count));
        double more = Math.max(1, Math.min(most, wanted));
        fresh.recovery = Recovery.RATE + (more - 1) * AT_ONCE;
        return (int) Math.ceil(usual * more);
    }

    /**
     * Number of faces that a body turns by in h seconds; after each it stands on another corner.
     */
    private double facesTurned(int slot, double h) {
        int corners = bodies.outline[slot].corners();
        return corners > 1 ? Math.abs(bodies.spin[slot]) * h * corners / (2 * Math.PI) : 0;
    }

    /** Deviation of a body's outline from its line in h seconds, by turning and by sliding, m. */
    private double leaves(int slot, double h) {
        double turn = bodies.sweepRadius[slot] > 0 ? Math.abs(bodies.spin[slot]) * h : 0;
        double way = h * (Math.abs(bodies.velocityX[slot]) + Math.abs(bodies.velocityY[slot]));
        return sagitta(slot, turn) + way * turn;
    }

    /** Whether an outline of a contact turns in the rest of the step, as the substep begins. */
    boolean isTurning(int row) {
        return isAnyTurning
                && (turnsFar[contacts.bodyA[row] / Motions.STRIDE]
                        || turnsFar[contacts.bodyB[row] / Motions.STRIDE]);
    }

    /** Makes a contact straight again that was bent in the last substep. */
    void straighten(int row) {
        if (isBent(row)) {
            bend(row, 0);
        }
    }

    /**
     * Number of parts of a substep of h seconds in which no body turns by more than an arc allows.
     */
    public int partsFor(double h) {
        double fastest = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            fastest = Math.max(fastest, turned(entry * Motions.STRIDE, h));
        }
        return (int) Math.max(1, Math.min(MOST_PARTS, Math.ceil(fastest / MOST_BEND)));
    }

    /** Angle by which a packed body turns in h seconds, rad; 0 for discs about their centre. */
    private double turned(int entry, double h) {
        boolean shows = entry > 0 && bodies.sweepRadius[motions.slots[entry / Motions.STRIDE]] > 0;
        return shows ? Math.abs(motions.data[entry + Motions.SPIN]) * h : 0;
    }

    /**
     * Measures again the contacts of bodies that turn far in the next h seconds and may close in
     * the rest ({@code left} s) of the step, and predicts how their gaps change.
     *
     * @return whether any contact was measured
     */
    public boolean measureTurned(double h, double left) {
        boolean isAny = false;
        for (int row = 0; row < contacts.count; row++) {
            boolean turns =
                    turned(contacts.bodyA[row], h) > FAR || turned(contacts.bodyB[row], h) > FAR;
            contacts.isNew[row] = turns && fresh.mayClose(row, left);
            if (contacts.isNew[row]) {
                fresh.measure(row, left);
                bend(row, h);
                isAny = true;
            }
        }
        return isAny;
    }

    /** Starts a substep; {@code left} seconds of the step remain. */
    void begin(double left) {
        isAnyTurning = false;
        if (turnsFar.length < motions.count) {
            turnsFar = new boolean[motions.slots.length];
        }
        for (int entry = 1; entry < motions.count; entry++) {
            turnsFar[entry] = isTurningBody(entry * Motions.STRIDE, left);
            isAnyTurning |= turnsFar[entry];
        }
    }

    /**
     * Widens the gap of a point by ½ω²h² of its arm, since within a substep a point that turns with
     * its body deviates by that much from its tangent, towards the centre of mass. Along the
     * surface the point may run ahead by as much as keeps it in place. A body that pivots on a
     * corner then keeps its energy up to terms in h². If the gap closes by turning, the contact
     * must part as fast as it closes.
     */
    void bend(int row, double h) {
        int at = row * PackedContacts.STRIDE;
        double[] d = contacts.data;
        double bendA = bend(pairs.bodyA[contacts.pair[row]], contacts.bodyA[row], h);
        double bendB = bend(pairs.bodyB[contacts.pair[row]], contacts.bodyB[row], h);
        double gap = bendA * coreArmA(row) - bendB * coreArmB(row) + faceTurnsAway(row, h);
        double way0 =
                bendA * d[at + PackedContacts.LEVER_A0] - bendB * d[at + PackedContacts.LEVER_B0];
        double way1 =
                bendA * d[at + PackedContacts.LEVER_A1] - bendB * d[at + PackedContacts.LEVER_B1];
        double difference =
                contacts.points[row] == 2
                        ? d[at + PackedContacts.GAP1] - d[at + PackedContacts.GAP0]
                        : 1;
        double way = difference == 0 ? (way0 + way1) / 2 : difference > 0 ? way0 : way1;
        d[at + PackedContacts.GAP0] += Math.max(0, gap);
        d[at + PackedContacts.GAP1] += Math.max(0, gap);
        d[at + PackedContacts.NEARING] = gap < 0 ? -gap / h : 0;
        contacts.surface[row] = contacts.running[row] + (h > 0 ? way / h : 0);
    }

    private boolean isBent(int row) {
        return contacts.surface[row] != contacts.running[row]
                || contacts.data[row * PackedContacts.STRIDE + PackedContacts.NEARING] != 0;
    }

    /** Half the square of an outline's angle of turn in h seconds. */
    private double bend(int slot, int entry, double h) {
        double turn = turn(slot, entry, h);
        return turn * turn / 2;
    }

    /** Angle by which an outline turns in h seconds, rad, limited to {@link #MOST_BEND}. */
    private double turn(int slot, int entry, double h) {
        double turn = motions.data[entry + Motions.SPIN] * h;
        return bodies.sweepRadius[slot] > 0 ? Math.max(-MOST_BEND, Math.min(MOST_BEND, turn)) : 0;
    }

    /**
     * Further widening of a gap, m: the face of a contact that turns by φ while the other body
     * slides along it by s draws away by φs. For a rounded shape the sliding point is that of its
     * core, a radius ρ farther from the face, which draws nearer by ρφ²/2.
     */
    private double faceTurnsAway(int row, double h) {
        int pair = contacts.pair[row];
        int face = pairs.faceOf[pair];
        if (face == Pairs.NONE) {
            return 0;
        }
        boolean isOfA = face == pairs.bodyA[pair];
        double turn = turn(face, isOfA ? contacts.bodyA[row] : contacts.bodyB[row], h);
        if (turn == 0) {
            return 0;
        }
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        double armA = d[at + PackedContacts.LEVER_TA];
        double armB = d[at + PackedContacts.LEVER_TB];
        Outline other = bodies.outline[pairs.shapeOf(pair, pairs.other(pair, face))];
        if (other.radius() == 0) {
            return turn * h * motions.slide(contacts, row, armA, armB);
        }
        double coreA = isOfA ? armA : coreArmA(row);
        double coreB = isOfA ? coreArmB(row) : armB;
        double toCore = isOfA ? armB - coreB : coreA - armA;
        return turn * (h * motions.slide(contacts, row, coreA, coreB) + turn * toCore / 2);
    }

    /**
     * Position along the normal, from A's centre of mass, of what of A turns at a contact, m: the
     * face, or the corner of the core, which lies a radius inside of the outline.
     */
    private double coreArmA(int row) {
        int a = pairs.shapeA(contacts.pair[row]);
        double arm = contacts.data[row * PackedContacts.STRIDE + PackedContacts.LEVER_TA];
        if (bodies.outline[a].isCentredDisc()) {
            return 0;
        }
        boolean isFace = isFace(row, pairs.bodyA[contacts.pair[row]]);
        return isFace ? arm : arm - bodies.outline[a].radius();
    }

    /** The same of B, from B's centre of mass, m. */
    private double coreArmB(int row) {
        int b = pairs.shapeB(contacts.pair[row]);
        double arm = contacts.data[row * PackedContacts.STRIDE + PackedContacts.LEVER_TB];
        if (bodies.outline[b].isCentredDisc()) {
            return 0;
        }
        boolean isFace = isFace(row, pairs.bodyB[contacts.pair[row]]);
        return isFace ? arm : arm + bodies.outline[b].radius();
    }

    /** Whether the contact is on a face of a body, which turns about the body as a whole. */
    private boolean isFace(int row, int slot) {
        return pairs.faceOf[contacts.pair[row]] == slot;
    }

    private boolean isTurningBody(int entry, double left) {
        int slot = motions.slots[entry / Motions.STRIDE];
        double turn =
                Math.abs(motions.data[entry + Motions.TURN])
                        + Math.abs(motions.data[entry + Motions.SPIN]) * left;
        double width = bodies.smallestWidth[slot];
        // A chain has an infinite width, with which its turning cannot be compared.
        double unseen = width < Double.POSITIVE_INFINITY ? straight.unseen() * width : 0;
        return sagitta(slot, turn) > unseen;
    }

    private double sagitta(int slot, double turn) {
        return bodies.sweepRadius[slot] * turn * turn / 2;
    }
}
