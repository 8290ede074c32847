package rigibo.backend.flight;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.KeptOverlap;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Waking;

import java.util.Arrays;

/**
 * Flyers behind a body of a pile that others may hold up or lead off. Flight predicts that a body
 * of a pile keeps its velocity. But a column of bodies that falls on the ground is stopped within
 * the step, each body by the one ahead of it. A flyer that is predicted to miss the last one by a
 * hair would then go into it.
 *
 * <p>As the step begins, ways that bodies may be led off are handed on from contact to contact
 * ({@link Ways}). A flyer that such a body would get into joins its pile, and other bodies of piles
 * within its reach get a contact with it. A sleeper that may be led off wakes. A flyer also joins
 * where joints may lead a body into it ({@link Sway}).
 */
final class Followers {

    /** Depth from which on a flyer joins, as a share of the bystanders' allowance. */
    private static final double SHARE = 0.25;

    /**
     * Way that is handed on, as a share of the depth from which on a flyer joins: in a column, the
     * many small ones of its contacts add up.
     */
    private static final double LEAST = 0.3;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Trajectories paths;
    private final Bystanders bystanders;
    private final Waking waking;
    private final ExpectedHits hits;
    private final Disturbance.Joining joining;
    private final Ways ways;
    private final Sway sway;

    /** Depth in widths from which on a flyer joins. */
    private final double shareThatShows;

    /** By body: the reach within which its neighbourhood was searched in this step, m. */
    private double[] searched = new double[16];

    Followers(
            DataStorage data,
            Trajectories paths,
            Bystanders bystanders,
            Waking waking,
            ExpectedHits hits,
            Disturbance.Joining joining,
            Accuracy accuracy) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.paths = paths;
        this.bystanders = bystanders;
        this.waking = waking;
        this.hits = hits;
        this.joining = joining;
        sway = new Sway(data);
        shareThatShows = SHARE * bystanders.allowance();
        ways = new Ways(data, LEAST * shareThatShows, keptOverlap(accuracy));
    }

    /**
     * Overlap in widths that leads nobody off: any overlap where impacts are split, since bodies
     * are deep in each other there, and it is taken back over many steps.
     */
    private static double keptOverlap(Accuracy accuracy) {
        return accuracy.impacts() == ImpactMode.EVENTS
                ? KeptOverlap.ifCalm(true, accuracy)
                : Double.POSITIVE_INFINITY;
    }

    /** Joins all followers at the start of a step of dt seconds. */
    void join(double dt) {
        begin();
        int count = pairs.activeCount;
        for (int i = 0; i < count; i++) {
            add(pairs.active[i], dt);
        }
        for (int i = 0; sway.isAny() && i < count; i++) {
            int pair = pairs.active[i];
            joinIfSwayed(pair, pairs.bodyA[pair], dt);
            joinIfSwayed(pair, pairs.bodyB[pair], dt);
        }
        int known;
        do {
            known = ways.contacts();
            ways.handOn();
            for (int i = 0; i < ways.led.count; i++) {
                lookRound(ways.led.numbers[i], dt);
            }
        } while (ways.contacts() > known);
    }

    /** Lets the flyer of a pair join if joints could lead the other body into it. */
    private void joinIfSwayed(int pair, int slot, double dt) {
        boolean flies = paths.isFlyer(pairs.other(pair, slot));
        if (!flies || paths.isFlyer(slot) || !bodies.isDynamic(slot)) {
            return;
        }
        double reach = sway.reach(slot, dt);
        if (reach > shareThatShows * bodies.smallestWidth[slot]) {
            joinIfMet(pair, slot, reach, dt);
        }
    }

    private void begin() {
        sway.begin();
        if (searched.length < bodies.type.length) {
            searched = new double[bodies.type.length];
        }
        Arrays.fill(searched, 0, bodies.slots.high, 0);
        ways.begin();
    }

    /** Adds a pair if it is a contact of two bodies of piles. */
    private void add(int pair, double dt) {
        boolean isContact = pairs.points[pair] > 0;
        if (isContact && !paths.isFlyer(pairs.bodyA[pair]) && !paths.isFlyer(pairs.bodyB[pair])) {
            ways.add(pair, dt);
        }
    }

    /**
     * Lets flyers join that a body could be led into, and finds its contacts with other bodies of
     * piles, where it may be led farther than when its neighbourhood was last searched.
     */
    private void lookRound(int slot, double dt) {
        double reach = ways.reach(slot);
        if (!(reach > shareThatShows * bodies.smallestWidth[slot])
                || !(reach > Ways.GROWN * searched[slot])) {
            return;
        }
        searched[slot] = reach;
        wake(slot, dt);
        bystanders.lookAlong(slot, dt, reach);
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            int other = pairs.other(p, slot);
            if (!bodies.isDynamic(other)) {
                continue;
            }
            if (paths.isFlyer(other)) {
                joinIfMet(p, slot, reach, dt);
            } else if (pairs.points[p] == 0 && bystanders.isWithinReach(p, reach, 0, dt)) {
                ways.add(p, dt);
            }
        }
    }

    /** Wakes a sleeper that is led off, with all that it touches. */
    private void wake(int slot, double dt) {
        if (waking.isAsleep(slot)) {
            int known = pairs.activeCount;
            waking.wakeIntoPile(slot);
            for (int i = known; i < pairs.activeCount; i++) {
                add(pairs.active[i], dt);
            }
        }
    }

    /** Lets the flyer of a pair join if the other body could be led into it. */
    private void joinIfMet(int pair, int slot, double reach, double dt) {
        int points = pairs.points[pair];
        int flyer = pairs.other(pair, slot);
        if (!bystanders.isWithinReach(pair, reach, 0, dt)) {
            return;
        }
        double led = Math.max(ledTo(pair, slot), sway.reach(slot, dt));
        double depth = ways.closing(pair, dt) + falls(pair, flyer, dt) + led;
        if (!shows(pair, Math.min(led, depth))) {
            pairs.points[pair] = points;
            return;
        }
        joining.join(flyer, slot, 0, dt);
        // Joining measures the contact only for the predicted motions.
        bystanders.isWithinReach(pair, reach, 0, dt);
        hits.expect(pair, 0, led / dt, dt);
        for (int p = bodies.firstPair[flyer]; p != Pairs.NONE; p = pairs.nextOf(p, flyer)) {
            add(p, dt);
        }
    }

    /** Whether a way in m is so far that a flyer has to join. */
    private boolean shows(int pair, double way) {
        return way > shareThatShows * ways.width(pair);
    }

    /** How far a body may be led towards the other one of a contact, m. */
    private double ledTo(int pair, int slot) {
        double sign = slot == pairs.bodyA[pair] ? 1 : -1;
        return ways.ledTo(slot, sign * pairs.normalX[pair], sign * pairs.normalY[pair]);
    }

    /** How far a flyer falls towards the other one of a contact, m. */
    private double falls(int pair, int flyer, double dt) {
        double sign = flyer == pairs.bodyA[pair] ? 1 : -1;
        double pull =
                PairTolerances.along(
                        bodies.accelerationX[flyer],
                        bodies.accelerationY[flyer],
                        pairs.normalX[pair],
                        pairs.normalY[pair]);
        return sign * pull * dt * dt / 2;
    }
}
