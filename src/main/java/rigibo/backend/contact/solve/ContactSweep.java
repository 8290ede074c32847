package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.SPIN;
import static rigibo.backend.contact.row.Motions.VX;
import static rigibo.backend.contact.row.Motions.VY;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.SharedRows;
import rigibo.backend.storage.Bodies;
import rigibo.backend.team.Team;

import java.util.Arrays;

/**
 * Passes over the contacts of an island: the projected Gauss–Seidel method. Within a substep points
 * close no faster than their gap allows, and they only push (j ≥ 0 ⊥ v + gap/h ≥ 0). The two points
 * of a contact form one small complementarity problem, solved by trying its four cases, so that a
 * flat box responds at both corners at once and does not rock.
 *
 * <p>Passes alternate their direction, so that loads that reach the ground in one pass come back up
 * in the next. A pass solves only contacts that are due ({@link DueContacts}).
 */
public final class ContactSweep {

    /** Numbers in two cache lines, so that workers do not write into the same one. */
    private static final int APART = 32;

    private final Motions motions;
    private final PackedContacts contacts;
    private final Rubbing rubbing;
    private final ShockPropagation shock;
    private final DueContacts due;

    /** The columns of {@link #due}: reading them through it took 2 % more of towers that settle. */
    private double[] changed;

    private double[] seen;
    private double[] threshold;
    private double[] spare;
    private final boolean isBlock;

    /** Greatest impulse with which a driven body presses, N·s. */
    private double strongestPress = Double.POSITIVE_INFINITY;

    /** Length of the substep over that of its kick: 2 for half a kick, else 1. */
    private double softness;

    private final SharedRows shared;

    /** Solves contacts of one colour; a field, since a new one would be allocated for each pass. */
    private final Team.Pieces solvingPieces = this::solvePiece;

    /** By worker, at a distance of {@link #APART} numbers: how many contacts it found due. */
    private final int[] solvedBy;

    public ContactSweep(
            Bodies bodies,
            Motions motions,
            PackedContacts contacts,
            Rubbing rubbing,
            boolean isBlock,
            SharedRows shared) {
        this.motions = motions;
        this.contacts = contacts;
        this.rubbing = rubbing;
        shock = new ShockPropagation(bodies, motions, contacts);
        due = new DueContacts(motions, contacts, shared);
        this.isBlock = isBlock;
        this.shared = shared;
        solvedBy = new int[APART * shared.workers()];
    }

    /**
     * Makes passes until no contact is due, for a substep of h seconds whose kick lasts {@code
     * kick} seconds. The compliance of a contact is proportional to its force rather than its
     * impulse, so that a body with the same force in a half kick and in a whole one moves alike in
     * both, and can rest.
     *
     * @param share neglected change of speed, in widths of the contact per substep
     * @param quiet upper bound on the neglected change of speed of any contact, m/s
     * @param least that bound where the two bodies hardly move relative to each other, m/s
     * @param most most passes
     */
    public void run(
            double h,
            double kick,
            int substep,
            double share,
            double quiet,
            double least,
            int most) {
        softness = h / kick;
        begin(h, substep, share / h, quiet, least);
        goOn(most);
    }

    /**
     * Makes passes as {@link #run} does, after bodies have moved on within a substep. Contacts that
     * were measured again are solved first; any other is due once its bodies change their speed.
     */
    public void runNew(double h, int substep, double share, double quiet, double least, int most) {
        softness = 1;
        begin(h, substep, share / h, quiet, least);
        due.deferAllButNew();
        goOn(most);
    }

    /**
     * Hands impulses down to the ground where bodies would sink in by more than a number of widths
     * in the substep ({@link ShockPropagation}).
     */
    public void handDown(double most) {
        due.handDown(shock, most);
    }

    /** Makes at most a number of further passes, until no contact is due. */
    public void goOn(int most) {
        int solved = 1;
        for (int pass = 0; pass < most && solved > 0; pass++) {
            solved = pass(pass % 2 == 1);
        }
    }

    /**
     * Whether a contact would sink in by more than a number of widths in a substep of h seconds.
     */
    public boolean isSinking(double h, int substep, double most) {
        return due.isSinking(h, substep, most);
    }

    /** Limits the impulse with which driven bodies press, N·s. */
    public void limitPresses(double impulse) {
        strongestPress = impulse;
    }

    /**
     * One pass back over all contacts, for a substep of h seconds.
     *
     * @return the largest change of a body's speed in it, m/s
     */
    public double once(double h, int substep) {
        softness = 1;
        begin(h, substep, 0, 0, 0);
        pass(true);
        double most = 0;
        for (int body = 1; body < motions.count; body++) {
            most = Math.max(most, changed[body]);
        }
        return most;
    }

    /** Change of an entry's speed in the last sweep, m/s. */
    public double change(int entry) {
        return changed[entry];
    }

    /** Makes a pass; returns the number of contacts that were due. */
    private int pass(boolean isBack) {
        int solved = shared.areWorthwhile() ? passTogether(isBack) : passAlone(isBack);
        contacts.work.contactSolves += solved;
        return solved;
    }

    private int passAlone(boolean isBack) {
        int ground = contacts.groundStart;
        int solved = 0;
        for (int i = 0; i < contacts.count; i++) {
            solved += solveIfDue(isBack && i < ground ? ground - 1 - i : i);
        }
        return solved;
    }

    private int passTogether(boolean isBack) {
        Arrays.fill(solvedBy, 0);
        shared.pass(isBack, solvingPieces);
        int solved = 0;
        for (int by = 0; by < solvedBy.length; by += APART) {
            solved += solvedBy[by];
        }
        return solved;
    }

    private void solvePiece(int from, int to, int worker) {
        int solved = 0;
        for (int row = from; row < to; row++) {
            solved += solveIfDue(row);
        }
        solvedBy[APART * worker] += solved;
    }

    private void begin(double h, int substep, double sharePerSecond, double quiet, double least) {
        due.begin(h, substep, sharePerSecond, quiet, least);
        changed = due.changed;
        seen = due.seen;
        threshold = due.threshold;
        spare = due.spare;
    }

    /** Solves a contact if it is due; returns 1 if it was, else 0. */
    private int solveIfDue(int row) {
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double now = changed[a / Motions.STRIDE] + changed[b / Motions.STRIDE];
        if (now - seen[row] > threshold[row]) {
            solve(row, a, b);
            return 1;
        }
        return 0;
    }

    /** Solves friction first, by the present load, then the load. */
    private void solve(int row, int a, int b) {
        double[] d = contacts.data;
        double[] m = motions.data;
        int at = row * PackedContacts.STRIDE;
        boolean rolls = d[at + PackedContacts.ROLLING] > 0;
        if (rolls) {
            roll(row, a, b);
        }
        double nx = d[at + PackedContacts.NX];
        double ny = d[at + PackedContacts.NY];
        double massA = m[a + INVERSE_MASS];
        double massB = m[b + INVERSE_MASS];
        double inertiaA = m[a + INVERSE_INERTIA];
        double inertiaB = m[b + INVERSE_INERTIA];
        double vx = m[b + VX] - m[a + VX];
        double vy = m[b + VY] - m[a + VY];
        double spinA = m[a + SPIN];
        double spinB = m[b + SPIN];
        double old0 = d[at + PackedContacts.IMPULSE0];
        double old1 = d[at + PackedContacts.IMPULSE1];
        double jt = 0;
        double turnA = 0;
        double turnB = 0;
        double friction = d[at + PackedContacts.FRICTION];
        boolean isPressing = massA == 0 && a != 0 || massB == 0 && b != 0;
        boolean slips = false;
        if (friction > 0 && !rolls) {
            double leverA = d[at + PackedContacts.LEVER_TA];
            double leverB = d[at + PackedContacts.LEVER_TB];
            double slides =
                    nx * vy - ny * vx + leverB * spinB - leverA * spinA - contacts.surface[row];
            double oldT = d[at + PackedContacts.IMPULSE_T];
            double most = friction * (old0 + old1);
            double wanted =
                    (oldT - d[at + PackedContacts.MASS_T] * slides)
                            / (1 + softness * PackedContacts.COMPLIANCE);
            double kept = FrictionSolver.clamp(wanted, most);
            slips = kept != wanted;
            d[at + PackedContacts.IMPULSE_T] = kept;
            jt = kept - oldT;
            turnA = leverA * jt;
            turnB = leverB * jt;
            double both = massA + massB;
            vx -= both * jt * ny;
            vy += both * jt * nx;
            spinA -= inertiaA * turnA;
            spinB += inertiaB * turnB;
        }
        double la0 = d[at + PackedContacts.LEVER_A0];
        double lb0 = d[at + PackedContacts.LEVER_B0];
        double vn = nx * vx + ny * vy;
        double give = softness * d[at + PackedContacts.GIVE];
        double w0 = vn + lb0 * spinB - la0 * spinA + spare[2 * row] + give * old0;
        double jn;
        double parts = w0;
        if (contacts.points[row] == 1) {
            d[at + PackedContacts.IMPULSE0] = push(old0 - w0 * d[at + PackedContacts.M00]);
            if (isPressing) {
                limitPress(d, at);
            }
            jn = d[at + PackedContacts.IMPULSE0] - old0;
            turnA += la0 * jn;
            turnB += lb0 * jn;
        } else {
            double la1 = d[at + PackedContacts.LEVER_A1];
            double lb1 = d[at + PackedContacts.LEVER_B1];
            double w1 = vn + lb1 * spinB - la1 * spinA + spare[2 * row + 1] + give * old1;
            parts = w1 < w0 ? w1 : w0;
            solvePair(d, at, w0, w1);
            if (isPressing) {
                limitPress(d, at);
            }
            double j0 = d[at + PackedContacts.IMPULSE0] - old0;
            double j1 = d[at + PackedContacts.IMPULSE1] - old1;
            jn = j0 + j1;
            turnA += la0 * j0 + la1 * j1;
            turnB += lb0 * j0 + lb1 * j1;
        }
        threshold[row] = due.threshold(row, (old0 + old1) * (massA + massB), rolls ? 0 : parts);
        double jx = jn * nx - jt * ny;
        double jy = jn * ny + jt * nx;
        m[a + VX] -= massA * jx;
        m[a + VY] -= massA * jy;
        m[a + SPIN] -= inertiaA * turnA;
        m[b + VX] += massB * jx;
        m[b + VY] += massB * jy;
        m[b + SPIN] += inertiaB * turnB;
        double j = Math.abs(jn) + Math.abs(jt);
        int entryA = a / Motions.STRIDE;
        int entryB = b / Motions.STRIDE;
        changed[entryA] += massA * j + motions.reach[entryA] * inertiaA * Math.abs(turnA);
        changed[entryB] += massB * j + motions.reach[entryB] * inertiaB * Math.abs(turnB);
        // The friction of a sliding contact changes with the load that was just solved.
        double unseen = slips ? friction * Math.abs(jn) * (massA + massB) : 0;
        seen[row] = changed[entryA] + changed[entryB] - unseen;
    }

    /** Scales the load of a driven body's contact down to the greatest press. */
    private void limitPress(double[] d, int at) {
        double load = d[at + PackedContacts.IMPULSE0] + d[at + PackedContacts.IMPULSE1];
        if (load > strongestPress) {
            d[at + PackedContacts.IMPULSE0] *= strongestPress / load;
            d[at + PackedContacts.IMPULSE1] *= strongestPress / load;
        }
    }

    /** Solves rolling and friction together. */
    private void roll(int row, int a, int b) {
        double spinA = motions.data[a + SPIN];
        double spinB = motions.data[b + SPIN];
        rubbing.roll(row);
        changed[a / Motions.STRIDE] +=
                motions.reach[a / Motions.STRIDE] * Math.abs(motions.data[a + SPIN] - spinA);
        changed[b / Motions.STRIDE] +=
                motions.reach[b / Motions.STRIDE] * Math.abs(motions.data[b + SPIN] - spinB);
    }

    /** Writes the impulses that bring w = v + gap/h to w ≥ 0, j ≥ 0, w·j = 0. */
    private void solvePair(double[] d, int at, double w0, double w1) {
        double old0 = d[at + PackedContacts.IMPULSE0];
        double old1 = d[at + PackedContacts.IMPULSE1];
        if (!isBlock) {
            double j0 = push(old0 - w0 / d[at + PackedContacts.K00]);
            double after1 = w1 + d[at + PackedContacts.K01] * (j0 - old0);
            d[at + PackedContacts.IMPULSE0] = j0;
            d[at + PackedContacts.IMPULSE1] = push(old1 - after1 / d[at + PackedContacts.K11]);
            return;
        }
        double both0 = old0 - d[at + PackedContacts.M00] * w0 - d[at + PackedContacts.M01] * w1;
        double both1 = old1 - d[at + PackedContacts.M01] * w0 - d[at + PackedContacts.M11] * w1;
        if (both0 < 0 || both1 < 0) {
            double k00 = d[at + PackedContacts.K00];
            double k01 = d[at + PackedContacts.K01];
            double k11 = d[at + PackedContacts.K11];
            // The speeds w without any impulse of these two points.
            double free0 = w0 - k00 * old0 - k01 * old1;
            double free1 = w1 - k01 * old0 - k11 * old1;
            double only0 = push(-free0 / k00);
            double only1 = push(-free1 / k11);
            // Round-off can rule out all remaining cases: the nearer one is then the solution.
            boolean isFirst = free1 + k01 * only0 >= free0 + k01 * only1;
            both0 = isFirst ? only0 : 0;
            both1 = isFirst ? 0 : only1;
        }
        d[at + PackedContacts.IMPULSE0] = both0;
        d[at + PackedContacts.IMPULSE1] = both1;
    }

    /**
     * The impulse if it pushes, otherwise 0. Math.max takes three times as long, since it
     * distinguishes signed zeros.
     */
    private static double push(double wanted) {
        return wanted > 0 ? wanted : 0;
    }
}
