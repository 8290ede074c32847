package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.Motions.DX;
import static rigibo.backend.contact.row.Motions.DY;
import static rigibo.backend.contact.row.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.TURN;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.KeptOverlap;

/**
 * Removes overlap by moving bodies instead of accelerating them. A velocity that parts bodies would
 * stay in the impulses from which the next substep is warm started, and a stack would never come to
 * rest completely.
 */
public final class OverlapSolver {

    /**
     * Ratio of masses up to which crushed bodies are separated as a jam. With larger ratios the
     * pushes would hardly move the heavy body: one of a thousand times the mass that presses
     * another against a wall, for instance.
     */
    private static final double ALIKE = 30;

    /** Highest speed at which overlap that goes at once moves a body, widths per second. */
    private static final double MOST_PUSH_AT_ONCE = 0.5;

    /** Overlap with the ground that can be seen, in widths. */
    private static final double SHOWS = 0.01;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;
    private final PartingLimit limit;
    private final GroundHold ground;
    private final LiftLimit lift;
    private final Accuracy accuracy;
    private final Jam jam;

    /** Kept overlap in the packed island, in widths. */
    private double kept;

    /**
     * Overlap that is removed at once in the packed island, in widths: where bodies are few and
     * hardly move, as much as a crowd keeps. A share per substep would take dozens of steps until
     * the rest of it is round-off, and until then the island would be solved in each of them.
     */
    private double last;

    /** Whether the packed island is jammed: calm, and with crushed bodies. */
    private boolean isJammed;

    /** Whether only the upper of two bodies is moved in the packed island. */
    private boolean raises;

    /** The contacts with more than the kept overlap. */
    private int[] deep = new int[16];

    private int deepCount;

    public OverlapSolver(
            Bodies bodies, Motions motions, PackedContacts contacts, Accuracy accuracy) {
        this.motions = motions;
        this.contacts = contacts;
        this.bodies = bodies;
        limit = new PartingLimit(bodies, motions, contacts);
        ground = new GroundHold(motions, contacts);
        lift = new LiftLimit(bodies, motions);
        this.accuracy = accuracy;
        jam = new Jam(bodies, motions, contacts, ground);
    }

    /** Prepares the packed island, which has no joints. */
    public void prepare(boolean isCalm) {
        boolean isCrowd = contacts.areCrowd();
        isJammed = isCalm && contacts.isAnyCrushed && motions.massRatio() <= ALIKE;
        raises = isCrowd && !isJammed;
        jam.reserve();
        kept = isCalm ? KeptOverlap.ifCalm(isCrowd, accuracy) : KeptOverlap.of(isCrowd, accuracy);
        last = isCalm && !isCrowd ? KeptOverlap.of(true, accuracy) : 0;
    }

    /**
     * Prepares the packed island, which has joints. The lower of two bodies may hang there rather
     * than lie on others, so that no body is raised in its place.
     */
    public void prepareJointed() {
        isJammed = false;
        raises = false;
        kept = KeptOverlap.of(contacts.areCrowd(), accuracy);
        last = 0;
    }

    /** Starts the removal of overlap in an island without joints. */
    public void begin() {
        limit.begin();
        ground.begin();
    }

    /**
     * Ends the removal of overlap in a substep of h seconds. Contacts with immovable bodies are
     * restored last, since several bodies together can push one into them.
     */
    public void end(double h, int substep) {
        ground.hold(substep);
        endWithin(h);
    }

    private void endWithin(double h) {
        limit.end(Recovery.mostWay(h));
    }

    /**
     * Makes passes over all overlapping contacts, for a substep of h seconds, from the ground up
     * and back. Together they part two bodies no faster than a single pass may.
     */
    public void correctInPasses(double h, int substep, int passes) {
        if (findDeep(substep)) {
            limit.begin();
            pass(h, passes);
            endWithin(h);
        }
    }

    /** Makes these passes in an island without joints, then restores contacts with the ground. */
    public void correctAndHoldGround(double h, int substep, int passes) {
        if (isJammed) {
            partJammed(h, substep);
            return;
        }
        if (findDeep(substep)) {
            begin();
            noteGround(h);
            if (raises) {
                lift.begin();
            }
            pass(h, passes);
            if (raises) {
                lift.end(h);
            }
            end(h, substep);
        }
    }

    /**
     * Highest speed at which removal of overlap moves a body of the packed island, widths per
     * second. Where overlap goes at once, a tower that lists by a little at each storey would else
     * be set upright within a substep, and its top into what stands beside it.
     */
    double mostPush() {
        return last > 0 ? MOST_PUSH_AT_ONCE : Recovery.MOST_PUSH;
    }

    /** Whether the packed island is jammed: calm, and with crushed bodies. */
    public boolean isJammed() {
        return isJammed;
    }

    /** Removes overlap in a jammed island, in a substep of h seconds. */
    public void partJammed(double h, int substep) {
        if (findDeep(substep)) {
            ground.begin();
            noteGround(h);
            jam.part(deep, deepCount, kept, h, substep);
        }
    }

    /**
     * Whether removal would move no body of a jammed island that has not moved yet, in h seconds.
     */
    public boolean isBlocked(double h) {
        if (isJammed) {
            partJammed(h, 0);
        }
        return isJammed && motions.areWhereTheyWere();
    }

    private void pass(double h, int passes) {
        for (int pass = 0; pass < passes; pass++) {
            boolean isUpwards = pass % 2 == 0;
            for (int i = 0; i < deepCount; i++) {
                correct(deep[isUpwards ? deepCount - 1 - i : i], h, Recovery.MOST_PUSH / passes);
            }
        }
    }

    private boolean isDeep(int row) {
        double least = -kept * contacts.width(row);
        return motions.gap(contacts, row, 0) < least
                || contacts.points[row] == 2 && motions.gap(contacts, row, 1) < least;
    }

    /** Finds the contacts that overlap by more than may stay; whether there are any. */
    public boolean findDeep(int substep) {
        if (deep.length < contacts.count) {
            deep = new int[contacts.pair.length];
        }
        deepCount = 0;
        for (int row = 0; row < contacts.count; row++) {
            if (isDeep(row) && contacts.firstSubstep[row] <= substep) {
                deep[deepCount++] = row;
            }
        }
        return deepCount > 0;
    }

    /**
     * Stores how deep bodies may be in the ground after h seconds of removal. Bodies that are
     * visibly deep come out at the rate of one contact, however many others push them in.
     */
    private void noteGround(double h) {
        for (int row = contacts.groundStart; row < contacts.count; row++) {
            double width = contacts.width(row);
            for (int point = 0; point < contacts.points[row]; point++) {
                if (motions.gap(contacts, row, point) < -SHOWS * width) {
                    ground.open(row, point, wanted(row, point, h));
                }
            }
        }
    }

    /** One pass over all rows. */
    public void correct(double h, int substep) {
        for (int row = 0; row < contacts.count; row++) {
            if (contacts.firstSubstep[row] <= substep) {
                correct(row, h, Recovery.MOST_PUSH);
            }
        }
    }

    /** Whether a gap is to open by more than a share of a width within h seconds. */
    public boolean isAnyWanted(double share, double h, int substep) {
        for (int row = 0; row < contacts.count; row++) {
            if (contacts.firstSubstep[row] <= substep) {
                double least = share * contacts.width(row);
                for (int point = 0; point < contacts.points[row]; point++) {
                    if (wanted(row, point, h) > least) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /** Distance by which a point's gap is to open within h seconds, m; 0 without overlap. */
    double wanted(int row, int point, double h) {
        return wanted(row, point, h, Recovery.MOST_PUSH);
    }

    /** That distance with a highest speed in widths per second, m. */
    private double wanted(int row, int point, double h, double speed) {
        int at = row * PackedContacts.STRIDE;
        double width = contacts.data[at + PackedContacts.WIDTH];
        double overlap = -motions.gap(contacts, row, point) - kept * width;
        double rate = contacts.data[at + PackedContacts.RECOVERY];
        double most = speed * width * h;
        // Both points go alike: one that were raised more would turn the body.
        boolean isLast = -motions.gap(contacts, row) < last * width;
        double wanted = isLast ? overlap : overlap * rate * h / (1 + rate * h);
        return overlap > 0 ? Math.min(wanted, most) : 0;
    }

    private void correct(int row, double h, double speed) {
        double want0 = wanted(row, 0, h, speed);
        double want1 = contacts.points[row] == 2 ? wanted(row, 1, h, speed) : 0;
        if (want0 == 0 && want1 == 0) {
            return;
        }
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        double both0 = d[at + PackedContacts.M00] * want0 + d[at + PackedContacts.M01] * want1;
        double both1 = d[at + PackedContacts.M01] * want0 + d[at + PackedContacts.M11] * want1;
        if (want1 == 0 || both1 < 0) {
            move(row, want0 / d[at + PackedContacts.K00], 0);
        } else if (want0 == 0 || both0 < 0) {
            move(row, 0, want1 / d[at + PackedContacts.K11]);
        } else {
            move(row, both0, both1);
        }
    }

    /** Displaces both bodies, as impulses at the points would move them in one second, kg·m. */
    private void move(int row, double push0, double push1) {
        double[] d = contacts.data;
        double[] m = motions.data;
        int at = row * PackedContacts.STRIDE;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double px = (push0 + push1) * d[at + PackedContacts.NX];
        double py = (push0 + push1) * d[at + PackedContacts.NY];
        double onA =
                push0 * d[at + PackedContacts.LEVER_A0] + push1 * d[at + PackedContacts.LEVER_A1];
        double onB =
                push0 * d[at + PackedContacts.LEVER_B0] + push1 * d[at + PackedContacts.LEVER_B1];
        m[a + DX] -= m[a + INVERSE_MASS] * px;
        m[a + DY] -= m[a + INVERSE_MASS] * py;
        m[a + TURN] -= m[a + INVERSE_INERTIA] * onA;
        m[b + DX] += m[b + INVERSE_MASS] * px;
        m[b + DY] += m[b + INVERSE_MASS] * py;
        m[b + TURN] += m[b + INVERSE_INERTIA] * onB;
        if (raises) {
            raise(a, b, px, py);
        }
    }

    /**
     * Moves two bodies that were pushed apart by the same displacement, so that only the upper one
     * has moved if it lies straight above. Otherwise the bodies below would have to push the lower
     * one back, storey by storey, and a heap would keep creeping.
     */
    private void raise(int a, int b, double px, double py) {
        double[] m = motions.data;
        if (m[a + INVERSE_MASS] == 0 || m[b + INVERSE_MASS] == 0) {
            return;
        }
        int slotA = motions.slots[a / Motions.STRIDE];
        int slotB = motions.slots[b / Motions.STRIDE];
        double pullX = bodies.accelerationX[slotA] + bodies.accelerationX[slotB];
        double pullY = bodies.accelerationY[slotA] + bodies.accelerationY[slotB];
        double along = pullX * px + pullY * py;
        double all = (pullX * pullX + pullY * pullY) * (px * px + py * py);
        if (all > 0) {
            double share = along * along / all;
            double with = share * (along < 0 ? m[a + INVERSE_MASS] : -m[b + INVERSE_MASS]);
            m[a + DX] += with * px;
            m[a + DY] += with * py;
            m[b + DX] += with * px;
            m[b + DY] += with * py;
        }
    }
}
