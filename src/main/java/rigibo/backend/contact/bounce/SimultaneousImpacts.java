package rigibo.backend.contact.bounce;

import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.impact.Impact;
import rigibo.backend.impact.TiedImpacts;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.KeptOverlap;
import rigibo.backend.storage.Pairs;

import java.util.Arrays;

/**
 * Impacts inside a small pile, in time order, each resolved together with all contacts that touch
 * then: a ball that falls on a box standing on the floor rebounds as from the floor.
 *
 * <p>A substep is split at the impact: up to then bodies move at their old velocities, and from
 * there on at the new ones. Between two kicks a velocity v is that at the middle of the substep. At
 * the time τ of the substep it is v + a·(τ − h/2), which the impact law uses, so that a ball of
 * elasticity 1 keeps its height at any length of the substep.
 */
final class SimultaneousImpacts {

    /** Most impacts in one substep; a longer chain continues in the next one. */
    private static final int MOST_IMPACTS = 32;

    /** Gap up to which a contact takes part, as a multiple of the kept overlap. */
    private static final double TOUCHING = 10;

    /**
     * Gap in widths up to which a point touched before the kick. A body that landed in the substep
     * before is where it stopped up to round-off, and round-off must not tell a load from an
     * impact.
     */
    private static final double TOUCHED = 1e-8;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Motions motions;
    private final PackedContacts contacts;
    private final Kick kick;
    private final BounceRows bounces;
    private final HitNotes notes;
    private final Impact impact = new Impact();
    private final TiedImpacts together;
    private final ImpactShifts shifts;

    /**
     * Way in widths that may lead what touches into each other: what passes may miss a contact by
     * in a substep, the tolerance of impacts to the power of three quarters.
     */
    private final double leftInto;

    /** Number of the present substep. */
    private int substep;

    /** Its length, s. */
    private double h;

    /** Time after its start at which the velocities hold, s. */
    private double middle;

    /** Multiplications left in the budget for the impacts of the step. */
    private double left;

    /** The rows that strike at the present time. */
    private int[] striking = new int[16];

    private int strikingCount;

    /** Number of times at which bodies were struck in the substep. */
    private int instants;

    SimultaneousImpacts(
            DataStorage data,
            Motions motions,
            PackedContacts contacts,
            Kick kick,
            BounceRows bounces,
            HitNotes notes,
            double tolerance) {
        double root = Math.sqrt(tolerance);
        leftInto = root * Math.sqrt(root);
        bodies = data.bodies;
        pairs = data.pairs;
        this.motions = motions;
        this.contacts = contacts;
        this.kick = kick;
        this.bounces = bounces;
        this.notes = notes;
        together = new TiedImpacts(bodies, pairs);
        shifts = new ImpactShifts(bodies, motions, contacts);
    }

    /** Starts the packed island with a budget for its impacts in this step, in multiplications. */
    void begin(double worth) {
        left = worth;
    }

    /**
     * Resolves all impacts within a substep of h seconds. Returns whether the rest of the step's
     * budget was enough; impacts beyond it are not resolved.
     */
    boolean resolve(double length, int number) {
        boolean isAnswered = resolve(length, length / 2, number);
        if (instants > 0) {
            // A body that lay on others is stopped by them from the substep's start. But its speed
            // had not been stopped yet when the impact placed it, so that place may lie within
            // them.
            shifts.limitOfTouching(number, TOUCHED, length, leftInto);
        }
        return isAnswered;
    }

    /**
     * Resolves the impacts at the present velocities, within a length (s) that counts as no time.
     * Returns whether the rest of the step's budget was enough.
     */
    boolean resolveAtOnce(double length, int number) {
        return resolve(length, 0, number);
    }

    private boolean resolve(double length, double middleOfVelocities, int number) {
        h = length;
        instants = 0;
        middle = middleOfVelocities;
        substep = number;
        boolean isAnswered = true;
        for (int impact = 0; impact < MOST_IMPACTS && isAnswered && left > 0; impact++) {
            double time = firstImpact();
            if (time > h) {
                return true;
            }
            isAnswered = strike(time);
        }
        return left > 0;
    }

    /** Time of the first impact of any row, s into the substep; infinite if there is none. */
    private double firstImpact() {
        double first = Double.POSITIVE_INFINITY;
        for (int i = 0; i < bounces.count; i++) {
            int row = bounces.elastic[i];
            if (contacts.firstSubstep[row] <= substep) {
                for (int point = 0; point < contacts.points[row]; point++) {
                    first = Math.min(first, strikesAt(row, point));
                }
            }
        }
        return first;
    }

    /**
     * Time of a point's impact, s into the substep; infinite if there is none or it is too slow.
     */
    private double strikesAt(int row, int point) {
        double speed = motions.parting(contacts, row, point);
        double gap = motions.gap(contacts, row, point);
        if (gap + h * speed >= 0) {
            return Double.POSITIVE_INFINITY;
        }
        double pull = gained(row, point);
        double time = Math.min(h, timeToClose(gap, speed - middle * pull, pull));
        return strikes(row, point, time) ? time : Double.POSITIVE_INFINITY;
    }

    /**
     * Whether a point closes fast enough at a time to be an impact. A point that touched before the
     * kick that presses it, or before the face under it turned, carries a load and does not strike,
     * however fast it would close without an impulse.
     */
    private boolean strikes(int row, int point, double time) {
        double speed = motions.parting(contacts, row, point);
        double met = met(row, point, time);
        double width = contacts.width(row);
        boolean touched = motions.gap(contacts, row, point) <= TOUCHED * width;
        double unloaded = speed - gainedInAll(row, point) + turnedBy(row);
        double parting = touched ? Math.max(met, unloaded) : met;
        double limit = contacts.data[row * PackedContacts.STRIDE + PackedContacts.BOUNCE_SPEED];
        return parting < -Math.max(IslandImpacts.RESIDUAL, limit);
    }

    /** Parting speed of a point at a time, m/s. */
    private double met(int row, int point, double time) {
        return motions.parting(contacts, row, point) + (time - middle) * gained(row, point);
    }

    /** The first root of gap + v·τ + a·τ²/2, by the form that does not cancel. */
    private static double timeToClose(double gap, double v, double a) {
        if (gap <= 0) {
            return 0;
        }
        double discriminant = v * v - 2 * a * gap;
        return v < 0 && discriminant >= 0
                ? 2 * gap / (-v + Math.sqrt(discriminant))
                : a < 0 ? (v + Math.sqrt(Math.max(0, discriminant))) / -a : 0;
    }

    /** Parting acceleration of a point, m/s². */
    private double gained(int row, int point) {
        return gained(row, point, contacts.bodyB[row]) - gained(row, point, contacts.bodyA[row]);
    }

    /** Change of a point's parting speed in the kick, m/s. */
    private double gainedInAll(int row, int point) {
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        return kick.length(b) * gained(row, point, b) - kick.length(a) * gained(row, point, a);
    }

    /** Growth of the closing speed since the last substep that is due to turning alone, m/s. */
    private double turnedBy(int row) {
        return 2 * contacts.data[row * PackedContacts.STRIDE + PackedContacts.NEARING];
    }

    /** Acceleration of a body's point of a contact along the normal, m/s². */
    private double gained(int row, int point, int body) {
        int at = row * PackedContacts.STRIDE;
        double[] d = contacts.data;
        int lever = body == contacts.bodyA[row] ? PackedContacts.LEVER_A0 : PackedContacts.LEVER_B0;
        return d[at + PackedContacts.NX] * kick.gained(body, Motions.VX)
                + d[at + PackedContacts.NY] * kick.gained(body, Motions.VY)
                + d[at + 2 * point + lever] * kick.gained(body, Motions.SPIN);
    }

    /**
     * Resolves simultaneous impacts; returns whether they have a solution. Without one, the rows
     * have to hold them; they are left out if they take more than the rest of the budget.
     */
    private boolean strike(double time) {
        moveVelocities(time - middle);
        if (bodies.turns()) {
            moveSpins(time - middle);
        }
        together.clear();
        strikingCount = 0;
        for (int row = 0; row < contacts.count; row++) {
            if (contacts.firstSubstep[row] <= substep) {
                add(row, time);
            }
        }
        boolean isAnswered = together.solve(left);
        left -= together.work();
        contacts.work.multiplications += together.work();
        if (isAnswered || left > 0) {
            together.keep(isAnswered);
            if (instants++ == 0) {
                shifts.begin();
            }
            double before = motions.energy(motions.data);
            noteStrikes(time);
            takeVelocities(time);
            if (bodies.turns()) {
                takeSpins(time);
            }
            countStrikes();
            shifts.take(before - motions.energy(motions.data));
        }
        return isAnswered;
    }

    /** Records the hits, at the velocities before the impacts, which the motions still hold. */
    private void noteStrikes(double time) {
        for (int i = 0; i < strikingCount; i++) {
            int row = striking[i];
            load(row, row * PackedContacts.STRIDE);
            double closing = 0;
            for (int point = 0; point < contacts.points[row]; point++) {
                if (strikes(row, point, time)) {
                    contacts.addPoint(row, point, impact);
                    closing = Math.max(closing, -met(row, point, time));
                }
            }
            notes.note(row, impact, closing, time);
        }
    }

    private void countStrikes() {
        for (int i = 0; i < strikingCount; i++) {
            pairs.impacts[contacts.pair[striking[i]]]++;
        }
        contacts.impacts += strikingCount;
        contacts.work.impacts += strikingCount;
    }

    /** Writes all velocities, advanced by a time in s, to the columns. */
    private void moveVelocities(double later) {
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            int at = entry * Motions.STRIDE;
            bodies.velocityX[slot] = at(at, Motions.VX, later);
            bodies.velocityY[slot] = at(at, Motions.VY, later);
        }
    }

    private void moveSpins(double later) {
        for (int entry = 1; entry < motions.count; entry++) {
            bodies.spin[motions.slots[entry]] = at(entry * Motions.STRIDE, Motions.SPIN, later);
        }
    }

    private double at(int body, int column, double later) {
        return motions.data[body + column] + later * kick.gained(body, column);
    }

    /** Adds the points of a row that touch at a time, and its elasticity if it strikes then. */
    private void add(int row, double time) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        load(row, at);
        boolean strikes = false;
        for (int point = 0; point < contacts.points[row]; point++) {
            double touching = TOUCHING * KeptOverlap.LEAST * d[at + PackedContacts.WIDTH];
            if (gapAt(row, point, time) <= touching) {
                contacts.addPoint(row, point, impact);
                strikes |= strikes(row, point, time);
            }
        }
        together.add(contacts.pair[row], impact, strikes ? d[at + PackedContacts.ELASTICITY] : 0);
        if (strikes) {
            if (strikingCount == striking.length) {
                striking = Arrays.copyOf(striking, 2 * strikingCount);
            }
            striking[strikingCount++] = row;
        }
    }

    private double gapAt(int row, int point, double time) {
        double pull = gained(row, point);
        double speed = motions.parting(contacts, row, point) - middle * pull;
        return motions.gap(contacts, row, point) + time * (speed + time * pull / 2);
    }

    private void load(int row, int at) {
        impact.load(bodies, pairs, contacts.pair[row]);
        impact.normalX = contacts.data[at + PackedContacts.NX];
        impact.normalY = contacts.data[at + PackedContacts.NY];
    }

    /** Takes over the new velocities, and shifts bodies for their old ones before the impact. */
    private void takeVelocities(double time) {
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            int at = entry * Motions.STRIDE;
            double x = take(at, Motions.VX, bodies.velocityX[slot], time);
            double y = take(at, Motions.VY, bodies.velocityY[slot], time);
            shifts.shift(at, -time * x, -time * y, 0);
        }
    }

    private void takeSpins(double time) {
        for (int entry = 1; entry < motions.count; entry++) {
            double after = bodies.spin[motions.slots[entry]];
            double turn = take(entry * Motions.STRIDE, Motions.SPIN, after, time);
            shifts.shift(entry * Motions.STRIDE, 0, 0, -time * turn);
        }
    }

    /** Takes what the impact changed of a speed, and returns it. */
    private double take(int body, int speed, double after, double time) {
        double gained = after - at(body, speed, time - middle);
        motions.data[body + speed] += gained;
        return gained;
    }
}
