package rigibo.backend.contact.bounce;

import static rigibo.backend.contact.row.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.SPIN;
import static rigibo.backend.contact.row.Motions.VX;
import static rigibo.backend.contact.row.Motions.VY;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.impact.Impact;
import rigibo.backend.impact.ImpactLaw;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

import java.util.Arrays;

/**
 * Impacts inside piles, resolved pair by pair, each at its time within the substep: up to the time
 * at which the gap closes bodies move at their old velocities, and from there on at the new ones.
 * The pairs that close fastest come first; an impact that makes a neighbour close fast is resolved
 * in the next sweep.
 *
 * <p>Between two kicks a velocity v is that at the middle of the substep. At the time τ a body that
 * nothing supports has the velocity v + a·(τ − h/2), with which it strikes. Its place needs no such
 * term: before and after the impact it is off by a·τ·(h − τ)/2, with opposite signs. With v itself
 * a bounce would gain or lose energy of up to weight · h · v, an error of first order in h.
 */
final class PairwiseImpacts {

    /** Share of the closing speed of a contact below which that of a point is round-off. */
    private static final double HARDLY = 1e-9;

    /** Most sweeps over the contacts in one substep; longer chains continue in the next substep. */
    private static final int MOST_SWEEPS = 8;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;
    private final Pairs pairs;
    private final HitNotes notes;
    private final Impact impact = new Impact();
    private final ImpactLaw law = new ImpactLaw();

    private final BounceRows bounces;
    private final ImpactShifts shifts;

    /** Rows that can bounce and close fast, with their speeds. */
    private long[] closing = new long[16];

    private int closingCount;

    /** By entry of the motions: the sweep of this substep in which it was last struck. */
    private int[] struckIn = new int[16];

    private static final int NEVER = -1;

    /** By entry of the motions: whether a contact supports it, or it has no acceleration. */
    private boolean[] isHeld = new boolean[16];

    /** Time of the present impact after the middle of the substep, s. */
    private double late;

    PairwiseImpacts(
            DataStorage data,
            Motions motions,
            PackedContacts contacts,
            BounceRows bounces,
            HitNotes notes) {
        bodies = data.bodies;
        this.motions = motions;
        this.contacts = contacts;
        this.bounces = bounces;
        shifts = new ImpactShifts(data.bodies, motions, contacts);
        pairs = data.pairs;
        this.notes = notes;
    }

    /** Resolves all impacts that fall into a substep of h seconds. */
    void resolve(double h, int substep) {
        reserve();
        findClosing(h, substep, 0);
        if (closingCount == 0) {
            return;
        }
        Arrays.fill(struckIn, 0, motions.count, NEVER);
        findHeld();
        shifts.begin();
        strikeClosing(h, 0);
        for (int sweep = 1; sweep < MOST_SWEEPS && closingCount > 0; sweep++) {
            findClosing(h, substep, sweep);
            strikeClosing(h, sweep);
        }
        shifts.limit(substep);
    }

    /**
     * In the kick that ends a step, leaves out contacts that will bounce but have not met yet; the
     * next step resolves their impacts. Solved as contacts they would lose their closing speed.
     */
    void leaveOpen(int substep) {
        reserve();
        if (bounces.count > 0) {
            findHeld();
        }
        for (int i = 0; i < bounces.count; i++) {
            int row = bounces.elastic[i];
            if (areFree(row) && isApart(row) && slowest(row) < -bounces.bounceSpeeds[i]) {
                contacts.joinsIn(row, substep + 1);
            }
        }
    }

    /** Whether a contact that carries nothing closes fast enough to bounce within h seconds. */
    boolean mayStrike(double h, int substep) {
        for (int i = 0; i < bounces.count; i++) {
            int row = bounces.elastic[i];
            if (contacts.firstSubstep[row] <= substep
                    && strikes(row, h, -bounces.bounceSpeeds[i])) {
                return true;
            }
        }
        return false;
    }

    private void reserve() {
        if (struckIn.length < motions.count) {
            struckIn = new int[motions.slots.length];
            isHeld = new boolean[motions.slots.length];
        }
    }

    /** Whether no contact supports the movable bodies of a contact. */
    private boolean areFree(int row) {
        return isFree(contacts.bodyA[row]) && isFree(contacts.bodyB[row]);
    }

    private boolean isFree(int at) {
        return !(motions.data[at + INVERSE_MASS] > 0) || !isHeld[at / Motions.STRIDE];
    }

    private boolean isApart(int row) {
        return motions.gap(contacts, row, 0) > 0
                && (contacts.points[row] == 1 || motions.gap(contacts, row, 1) > 0);
    }

    /** Marks bodies that contacts supported in the last substep: they do not fall until struck. */
    private void findHeld() {
        for (int entry = 0; entry < motions.count; entry++) {
            isHeld[entry] = !(motions.data[entry * Motions.STRIDE + INVERSE_MASS] > 0);
        }
        for (int row = 0; row < contacts.count; row++) {
            int at = row * PackedContacts.STRIDE;
            if (contacts.data[at + PackedContacts.IMPULSE0] > 0
                    || contacts.data[at + PackedContacts.IMPULSE1] > 0) {
                isHeld[contacts.bodyA[row] / Motions.STRIDE] = true;
                isHeld[contacts.bodyB[row] / Motions.STRIDE] = true;
            }
        }
    }

    private void strikeClosing(double h, int sweep) {
        for (int i = 0; i < closingCount; i++) {
            strike((int) closing[i] & Integer.MAX_VALUE, h, sweep);
        }
    }

    /**
     * Lists closing rows, sorted by the bits of their closing speed as a float, ties by row. After
     * the first sweep only rows of bodies struck in the last one can close.
     */
    private void findClosing(double h, int substep, int sweep) {
        closingCount = 0;
        if (closing.length < bounces.count) {
            closing = new long[bounces.elastic.length];
        }
        for (int i = 0; i < bounces.count; i++) {
            int row = bounces.elastic[i];
            if (contacts.firstSubstep[row] <= substep
                    && (sweep == 0 || wasStruck(row, sweep - 1))
                    && strikes(row, h, -bounces.bounceSpeeds[i])) {
                int order = ~Float.floatToIntBits((float) -slowest(row));
                closing[closingCount++] = (long) order << 32 | row;
            }
        }
        Arrays.sort(closing, 0, closingCount);
    }

    private boolean wasStruck(int row, int sweep) {
        return struckIn[contacts.bodyA[row] / Motions.STRIDE] == sweep
                || struckIn[contacts.bodyB[row] / Motions.STRIDE] == sweep;
    }

    private boolean strikes(int row, double h, double limit) {
        return strikes(row, 0, h, limit) || contacts.points[row] == 2 && strikes(row, 1, h, limit);
    }

    private boolean strikes(int row, int point, double h, double limit) {
        double v = motions.parting(contacts, row, point);
        return v < limit
                && v < -IslandImpacts.RESIDUAL
                && motions.gap(contacts, row, point) + h * v < 0;
    }

    private double slowest(int row) {
        double v0 = motions.parting(contacts, row, 0);
        return contacts.points[row] == 1 ? v0 : Math.min(v0, motions.parting(contacts, row, 1));
    }

    private void strike(int row, double h, int sweep) {
        if (!strikes(
                row,
                h,
                -contacts.data[row * PackedContacts.STRIDE + PackedContacts.BOUNCE_SPEED])) {
            return; // An earlier impact of this sweep turned it.
        }
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double time = timeOf(row, h);
        late = time - h / 2;
        load(row, h);
        double before = energy();
        notes.note(row, impact, -impact.slowestParting(), time);
        law.resolve(impact);
        take(a, time, impact.velocityAX, impact.velocityAY, impact.spinA);
        take(b, time, impact.velocityBX, impact.velocityBY, impact.spinB);
        shifts.take(before - energy());
        struckIn[a / Motions.STRIDE] = sweep;
        struckIn[b / Motions.STRIDE] = sweep;
        struckIn[0] = NEVER; // The ground goes on as before.
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.TOTAL] +=
                impact.totalNormalImpulse();
        pairs.impacts[contacts.pair[row]]++;
        contacts.impacts++;
        contacts.work.impacts++;
    }

    /** Sets a new velocity, and shifts the body for its old velocity before the impact. */
    private void take(int at, double time, double atImpactX, double atImpactY, double spin) {
        double[] m = motions.data;
        double x = atImpactX - gainX(at);
        double y = atImpactY - gainY(at);
        shifts.shift(
                at, time * (m[at + VX] - x), time * (m[at + VY] - y), time * (m[at + SPIN] - spin));
        m[at + VX] = x;
        m[at + VY] = y;
        m[at + SPIN] = spin;
    }

    /** Kinetic energy of the two bodies of the loaded impact, J. */
    private double energy() {
        double x = impact.velocityAX;
        double y = impact.velocityAY;
        double u = impact.velocityBX;
        double v = impact.velocityBY;
        return energy(impact.inverseMassA, x * x + y * y)
                + energy(impact.inverseInertiaA, impact.spinA * impact.spinA)
                + energy(impact.inverseMassB, u * u + v * v)
                + energy(impact.inverseInertiaB, impact.spinB * impact.spinB);
    }

    private static double energy(double inverse, double square) {
        return inverse > 0 ? square / inverse / 2 : 0;
    }

    /** Speed that an entry gains between the middle of the substep and the present impact, m/s. */
    private double gainX(int at) {
        int entry = at / Motions.STRIDE;
        return isHeld[entry] ? 0 : late * bodies.accelerationX[motions.slots[entry]];
    }

    private double gainY(int at) {
        int entry = at / Motions.STRIDE;
        return isHeld[entry] ? 0 : late * bodies.accelerationY[motions.slots[entry]];
    }

    /** Time of the first impact of a row's points within the substep of h seconds, s. */
    private double timeOf(int row, double h) {
        double time = h;
        double least = HARDLY * -slowest(row);
        for (int point = 0; point < contacts.points[row]; point++) {
            if (meets(row, point, h)) {
                double speed = -motions.parting(contacts, row, point);
                if (speed > least) {
                    double gap = Math.max(0, motions.gap(contacts, row, point));
                    time = Math.min(time, gap / speed);
                }
            }
        }
        return time;
    }

    private boolean meets(int row, int point, double h) {
        double closes = h * Math.min(0, motions.parting(contacts, row, point));
        return motions.gap(contacts, row, point) + closes <= 0;
    }

    /** Loads the points that strike, with the velocities at the present impact. */
    private void load(int row, double h) {
        double[] d = contacts.data;
        double[] m = motions.data;
        int at = row * PackedContacts.STRIDE;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        impact.normalX = d[at + PackedContacts.NX];
        impact.normalY = d[at + PackedContacts.NY];
        impact.friction = d[at + PackedContacts.FRICTION];
        impact.elasticity = d[at + PackedContacts.ELASTICITY];
        impact.surfaceSpeed = contacts.running[row];
        impact.inverseMassA = m[a + INVERSE_MASS];
        impact.inverseInertiaA = m[a + INVERSE_INERTIA];
        impact.inverseMassB = m[b + INVERSE_MASS];
        impact.inverseInertiaB = m[b + INVERSE_INERTIA];
        impact.velocityAX = m[a + VX] + gainX(a);
        impact.velocityAY = m[a + VY] + gainY(a);
        impact.spinA = m[a + SPIN];
        impact.velocityBX = m[b + VX] + gainX(b);
        impact.velocityBY = m[b + VY] + gainY(b);
        impact.spinB = m[b + SPIN];
        impact.points = 0;
        for (int point = 0; point < contacts.points[row]; point++) {
            if (meets(row, point, h)) {
                contacts.addPoint(row, point, impact);
            }
        }
    }
}
