package rigibo.backend.contact.row;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Angle;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;
import rigibo.backend.team.Team;

import java.util.Arrays;

/**
 * Contacts that are measured again within a step. The contacts of a body that joins the pile are
 * measured at the poses of the time of joining, since the pile has moved since the step's start.
 */
public final class FreshRows {

    /** Distance in m beyond which the square of a distance overflows. */
    private static final double FARTHEST = 1e150;

    /** Gap up to which a contact is measured however its bodies move, in widths. */
    private static final double NEAR = 0.01;

    /** Share of an overlap that contacts measured again remove per second, 1/s. */
    double recovery = Recovery.RATE;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Narrowphase narrowphase;
    private final Motions motions;
    private final PackedContacts contacts;
    private final RowBuilder builder;
    private final SharedRows shared;

    /** By worker: the object that measures contacts for it; the first one is this. */
    private final FreshRows[] helpers;

    /** Measures some of the marked contacts. */
    private final Team.Pieces measuringPieces = this::measurePiece;

    /** By contact: whether it has to be measured; and the time left in the step, s. */
    private boolean[] marked;

    private double left;

    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    /** By entry of the motions: the angle in rad whose cosine and sine are cached. */
    private double[] angles;

    private double[] cosines;
    private double[] sines;

    public FreshRows(
            DataStorage data,
            Narrowphase narrowphase,
            Motions motions,
            PackedContacts contacts,
            RowBuilder builder,
            SharedRows shared) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.narrowphase = narrowphase;
        this.motions = motions;
        this.contacts = contacts;
        this.builder = builder;
        this.shared = shared;
        forgetAngles();
        helpers = new FreshRows[shared.workers()];
        helpers[0] = this;
        SharedRows alone = new SharedRows(null, contacts);
        for (int i = 1; i < helpers.length; i++) {
            Narrowphase another = narrowphase.of(i);
            helpers[i] = new FreshRows(data, another, motions, contacts, builder, alone);
        }
    }

    /**
     * Measures the contacts of bodies that join in a substep that begins at {@code time}, s; {@code
     * left} seconds of the step remain.
     *
     * @return whether any body joins
     */
    public boolean measureJoining(int substep, double time, double left) {
        boolean isAny = false;
        for (int row = 0; substep <= contacts.lastJoining && row < contacts.count; row++) {
            if (contacts.firstSubstep[row] == substep) {
                measureAhead(row, left, Math.max(0, joinsAt(row) - time));
                isAny = true;
            }
        }
        return isAny;
    }

    /** Time at which the later of two bodies joins, s after the step's start. */
    private double joinsAt(int row) {
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double whenA = a == 0 ? 0 : bodies.pileTime[motions.slots[a / Motions.STRIDE]];
        double whenB = b == 0 ? 0 : bodies.pileTime[motions.slots[b / Motions.STRIDE]];
        return Math.max(whenA, whenB);
    }

    private void measureAhead(int row, double left, double ahead) {
        motions.drift(contacts.bodyA[row], ahead);
        motions.drift(contacts.bodyB[row], ahead);
        measure(row, left);
        motions.drift(contacts.bodyA[row], -ahead);
        motions.drift(contacts.bodyB[row], -ahead);
    }

    /**
     * Measures a contact at the present poses; {@code left} seconds of the step remain. If a body's
     * position is not finite, the contact is left as it was; that body will be put to rest where it
     * began the step.
     */
    public void measure(int row, double left) {
        int pair = contacts.pair[row];
        place(pairs.bodyA[pair], contacts.bodyA[row], poseA);
        place(pairs.bodyB[pair], contacts.bodyB[row], poseB);
        if (!isSomewhere(poseA) || !isSomewhere(poseB)) {
            return;
        }
        int at = row * PackedContacts.STRIDE;
        // The manifold transfers the values in its columns from its old points to its new ones.
        pairs.normalForce[2 * pair] = contacts.data[at + PackedContacts.IMPULSE0];
        pairs.normalForce[2 * pair + 1] = contacts.data[at + PackedContacts.IMPULSE1];
        narrowphase.measureAgain(pair, poseA, poseB, reach(row, pair, left));
        contacts.data[at + PackedContacts.IMPULSE0] = pairs.normalForce[2 * pair];
        contacts.data[at + PackedContacts.IMPULSE1] = pairs.normalForce[2 * pair + 1];
        double before0 = before(at, pairs.former[2 * pair]);
        double before1 = before(at, pairs.former[2 * pair + 1]);
        contacts.data[at + PackedContacts.BEFORE0] = before0;
        contacts.data[at + PackedContacts.BEFORE1] = before1;
        builder.rewrite(row);
        contacts.data[at + PackedContacts.RECOVERY] = recovery;
    }

    /** Whether contacts can be measured in any order: not where they lend each other points. */
    boolean isShareable() {
        return !narrowphase.isLending();
    }

    /**
     * Measures the marked contacts; {@code left} seconds of the step remain. Contacts with
     * immovable bodies may depend on each other, where such bodies meet in a seam: one worker
     * measures them in their order.
     */
    void measure(boolean[] marked, double left) {
        this.marked = marked;
        this.left = left;
        for (FreshRows helper : helpers) {
            helper.recovery = recovery;
        }
        shared.each(contacts.groundStart, measuringPieces);
        measurePiece(contacts.groundStart, contacts.count, 0);
    }

    private void measurePiece(int from, int to, int worker) {
        for (int row = from; row < to; row++) {
            if (marked[row]) {
                helpers[worker].measure(row, left);
            }
        }
    }

    private static boolean isSomewhere(Pose pose) {
        double sum = Math.abs(pose.x) + Math.abs(pose.y) + Math.abs(pose.cos);
        return sum < FARTHEST;
    }

    private double before(int at, int point) {
        return point == Pairs.NONE ? 0 : contacts.data[at + PackedContacts.BEFORE0 + point];
    }

    private void place(int slot, int at, Pose pose) {
        int entry = at / Motions.STRIDE;
        if (angles.length < motions.count) {
            forgetAngles();
        }
        double angle = bodies.angle[slot] + motions.data[at + Motions.TURN];
        // The sine of a zero has the sign of that zero.
        if (angles[entry] != angle || angle == 0) {
            angles[entry] = angle;
            cosines[entry] = Angle.cos(angle);
            sines[entry] = Angle.sin(angle);
        }
        pose.set(
                bodies.x[slot] + motions.data[at + Motions.DX],
                bodies.y[slot] + motions.data[at + Motions.DY],
                cosines[entry],
                sines[entry]);
    }

    private void forgetAngles() {
        angles = new double[motions.slots.length];
        cosines = new double[motions.slots.length];
        sines = new double[motions.slots.length];
        Arrays.fill(cosines, 1);
    }

    /**
     * Whether a contact may close in the rest of the step, s, even if its bodies reach twice their
     * speed.
     */
    boolean mayClose(int row, double left) {
        double width = contacts.width(row);
        double closing = NEAR * width + 2 * speed(row, contacts.pair[row]) * left;
        return gap(row) <= closing;
    }

    /** Present gap of a contact, m; for a contact without points a lower bound of it. */
    private double gap(int row) {
        int pair = contacts.pair[row];
        if (pairs.isAwaited(pair)) {
            return pairs.beside[pair]
                    - motions.moved(contacts.bodyA[row])
                    - motions.moved(contacts.bodyB[row]);
        }
        return motions.gap(contacts, row);
    }

    /** Whether a contact has no points yet although its bodies may come to touch. */
    boolean isAwaited(int row) {
        return pairs.isAwaited(contacts.pair[row]);
    }

    /** Largest gap that could close in the rest of the step, m. */
    private double reach(int row, int pair, double left) {
        double width = bodies.smallestWidth[pairs.bodyA[pair]];
        boolean isOfChain = width == Double.POSITIVE_INFINITY;
        double near = isOfChain ? bodies.smallestWidth[pairs.bodyB[pair]] : width;
        return 2 * speed(row, pair) * left + near;
    }

    /** Bound on the speed at which the bodies of a contact come together, m/s. */
    private double speed(int row, int pair) {
        double[] m = motions.data;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double speed =
                Math.abs(m[b + Motions.VX] - m[a + Motions.VX])
                        + Math.abs(m[b + Motions.VY] - m[a + Motions.VY]);
        if (bodies.turns()) {
            speed += Math.abs(m[a + Motions.SPIN]) * bodies.sweepRadius[pairs.bodyA[pair]];
            speed += Math.abs(m[b + Motions.SPIN]) * bodies.sweepRadius[pairs.bodyB[pair]];
        }
        return speed;
    }
}
