package rigibo.backend.flight;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.PointSpeeds;

import java.util.Arrays;

/**
 * Flyers behind a body of a pile that others may hold up or lead off. Flight predicts that a body
 * of a pile goes on as it went. But a column of bodies that falls on the ground is stopped within
 * the step, each body by the one ahead of it, and a flyer that misses the last one by a hair, since
 * that moves on, would go into it.
 *
 * <p>As the step begins, what may lead a body off is handed on from contact to contact: where two
 * would be in each other at the end of the step, one may give way to the other along the normal, by
 * a share of its mass and of all that pushes from behind; what is fixed or driven pushes without
 * giving way. All speeds are those of two bodies against each other, so nothing depends on the
 * frame of reference. A flyer that such a body would get into joins its pile.
 */
final class Followers {

    /** Factor by which a way must grow before it is handed on again. */
    private static final double GROWN = 1.05;

    /** Depth from which on a flyer joins, as a share of what bystanders may leave their path by. */
    private static final double SHARE = 0.25;

    /**
     * Way that is handed on, as a share of the depth from which on a flyer joins: in a column, the
     * many small ones of its contacts add up.
     */
    private static final double LEAST = 1.0 / 32;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Trajectories paths;
    private final Bystanders bystanders;
    private final ExpectedHits hits;
    private final Disturbance.Joining joining;

    /** Depth in widths from which on a flyer joins. */
    private final double shareThatShows;

    /**
     * By body, twice: how far it may be led off within the step, x and y, m; and the mass that
     * pushes, itself included, kg. The second way is opposed to the first.
     */
    private double[] wayX = new double[2 * 16];

    private double[] wayY = new double[2 * 16];
    private double[] mass = new double[2 * 16];

    /** Bodies whose neighbours are still to be asked, in the order found; and those in progress. */
    private final Found waiting = new Found();

    private final Found present = new Found();
    private boolean[] isWaiting = new boolean[16];

    Followers(
            DataStorage data,
            Trajectories paths,
            Bystanders bystanders,
            ExpectedHits hits,
            Disturbance.Joining joining) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.paths = paths;
        this.bystanders = bystanders;
        this.hits = hits;
        this.joining = joining;
        shareThatShows = SHARE * bystanders.allowance();
    }

    /** Joins all followers at the start of a step of dt seconds. */
    void join(double dt) {
        begin();
        int count = pairs.activeCount;
        for (int i = 0; i < count; i++) {
            int pair = pairs.active[i];
            int a = pairs.bodyA[pair];
            int b = pairs.bodyB[pair];
            if (pairs.points[pair] > 0 && !paths.isFlyer(a) && !paths.isFlyer(b)) {
                push(pair, a, b, dt);
                push(pair, b, a, dt);
            }
        }
        while (waiting.count > 0) {
            takeWaiting();
            for (int i = 0; i < present.count; i++) {
                askNeighbours(present.numbers[i], dt);
            }
        }
    }

    private void begin() {
        int capacity = bodies.type.length;
        if (isWaiting.length < capacity) {
            wayX = new double[2 * capacity];
            wayY = new double[2 * capacity];
            mass = new double[2 * capacity];
            isWaiting = new boolean[capacity];
        }
        waiting.reserve(capacity);
        present.reserve(capacity);
        Arrays.fill(wayX, 0, 2 * bodies.slots.high, 0);
        Arrays.fill(wayY, 0, 2 * bodies.slots.high, 0);
        Arrays.fill(mass, 0, 2 * bodies.slots.high, 0);
    }

    private void takeWaiting() {
        present.clear();
        for (int i = 0; i < waiting.count; i++) {
            isWaiting[waiting.numbers[i]] = false;
            present.add(waiting.numbers[i]);
        }
        waiting.clear();
    }

    /** Leads a body of a pile off by what the other one of a measured contact may do to it. */
    private void push(int pair, int by, int slot, double dt) {
        if (!mayMove(slot)) {
            return;
        }
        double sign = slot == pairs.bodyB[pair] ? 1 : -1;
        double nx = sign * pairs.normalX[pair];
        double ny = sign * pairs.normalY[pair];
        double closing = closing(pair, dt);
        push(pair, slot, closing, ownMass(by), nx, ny);
        for (int way = 2 * by; way < 2 * by + 2; way++) {
            double led = led(way, nx, ny);
            if (led > 0) {
                push(pair, slot, closing + led, mass[way], nx, ny);
            }
        }
    }

    private double ownMass(int slot) {
        return bodies.isDynamic(slot) ? 1 / bodies.inverseMass[slot] : Double.POSITIVE_INFINITY;
    }

    private void push(int pair, int slot, double closing, double pushing, double nx, double ny) {
        double own = ownMass(slot);
        double share = pushing == Double.POSITIVE_INFINITY ? 1 : pushing / (pushing + own);
        double led = closing * share;
        if (!(led > 0) || !shows(pair, led, LEAST)) {
            return;
        }
        int way = 2 * slot;
        if (led(way, nx, ny) < 0) {
            way++;
        }
        if (led > GROWN * lengthOf(way)) {
            wayX[way] = led * nx;
            wayY[way] = led * ny;
            mass[way] = pushing + own;
            if (!isWaiting[slot]) {
                isWaiting[slot] = true;
                waiting.add(slot);
            }
        }
    }

    private double led(int way, double nx, double ny) {
        return wayX[way] * nx + wayY[way] * ny;
    }

    private double lengthOf(int way) {
        return Math.sqrt(square(wayX[way]) + square(wayY[way]));
    }

    private static double square(double value) {
        return value * value;
    }

    /** Whether a way in m is so far that a flyer has to join, times a factor. */
    private boolean shows(int pair, double way, double factor) {
        double width = PairTolerances.width(bodies, pairs.bodyA[pair], pairs.bodyB[pair]);
        return way > factor * shareThatShows * width;
    }

    /** By how much a contact would be overlapping at the end of the step, m; it may be negative. */
    private double closing(int pair, double dt) {
        double most = Double.NEGATIVE_INFINITY;
        for (int point = 2 * pair; point < 2 * pair + pairs.points[pair]; point++) {
            most = Math.max(most, -dt * parting(pair, point) - pairs.separation[point]);
        }
        return most;
    }

    private double parting(int pair, int point) {
        if (bodies.turns()) {
            return PointSpeeds.parting(bodies, pairs, pair, point);
        }
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        return PairTolerances.along(
                bodies.velocityX[b] - bodies.velocityX[a],
                bodies.velocityY[b] - bodies.velocityY[a],
                pairs.normalX[pair],
                pairs.normalY[pair]);
    }

    /** Leads off what is beside a body that was led off; flyers among it join. */
    private void askNeighbours(int slot, double dt) {
        double reach = Math.max(lengthOf(2 * slot), lengthOf(2 * slot + 1));
        boolean isSeen = reach > shareThatShows * bodies.smallestWidth[slot];
        if (isSeen) {
            bystanders.lookRound(slot, 0, reach);
            bystanders.lookRound(slot, dt, reach);
        }
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            int other = pairs.other(p, slot);
            if (!mayMove(other)) {
                continue;
            }
            boolean isMet =
                    paths.isFlyer(other)
                            ? isSeen && joins(p, slot, reach, dt)
                            : isMet(p, isSeen, reach, dt);
            if (isMet) {
                push(p, slot, other, dt);
            }
        }
    }

    private boolean mayMove(int slot) {
        return bodies.isDynamic(slot) && bodies.awake[slot];
    }

    /** Whether two bodies of piles may meet if one of them is led off. */
    private boolean isMet(int pair, boolean isSeen, double reach, double dt) {
        return pairs.points[pair] > 0 || isSeen && bystanders.isWithinReach(pair, reach, 0, dt);
    }

    /** Lets the flyer of a pair join if the other body could be led into it; returns whether. */
    private boolean joins(int pair, int slot, double reach, double dt) {
        int points = pairs.points[pair];
        int flyer = pairs.other(pair, slot);
        if (!bystanders.isWithinReach(pair, reach, 0, dt)) {
            return false;
        }
        double led = ledTo(pair, slot);
        double depth = closing(pair, dt) + falls(pair, flyer, dt) + led;
        if (!shows(pair, Math.min(led, depth), 1)) {
            pairs.points[pair] = points;
            return false;
        }
        joining.join(flyer, slot, 0, dt);
        // Joining measures the contact only for the predicted motions.
        bystanders.isWithinReach(pair, reach, 0, dt);
        hits.expect(pair, 0, led / dt, dt);
        return true;
    }

    /** How far a body may be led towards the other one of a contact, m. */
    private double ledTo(int pair, int slot) {
        double sign = slot == pairs.bodyA[pair] ? 1 : -1;
        double nx = sign * pairs.normalX[pair];
        double ny = sign * pairs.normalY[pair];
        return Math.max(led(2 * slot, nx, ny), led(2 * slot + 1, nx, ny));
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
