package rigibo.backend.flight;

import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.collision.Narrowphase;
import rigibo.backend.collision.distance.Motion;
import rigibo.backend.collision.distance.TimeOfImpact;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.impact.Impact;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Roster;
import rigibo.backend.storage.Waking;

import java.util.Arrays;

/**
 * Moves the bodies in flight and resolves their impacts in time order. At an impact only its two
 * bodies are advanced to that time, and their other impacts are predicted again. Where impacts are
 * split within the step, whatever may meet by its own motion is in a pile already, and only who may
 * be driven into others is looked for.
 */
public final class Flight {

    /**
     * Impacts within this time of each other count as simultaneous, s per metre of impact
     * tolerance: a body at 1 m/s moves a thousandth of the tolerance in it.
     */
    private static final double TIE_PER_METRE = 1e-3;

    /**
     * Most restarts of the search for an impact with an edge of a chain, after it found a place
     * where the edge does not push.
     */
    private static final int MOST_LOOKS = 16;

    /** Distance between two restarts, as a share of the narrower one's width. */
    private static final double LOOK_AHEAD = 1e-3;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Counters counters;
    private final Waking waking;
    private final Narrowphase narrowphase;
    private final Broadphase broadphase;
    private final Accuracy accuracy;
    private final FreeFlight free;
    private final Trajectories paths;
    private final FlightImpacts impacts;
    private final Bystanders bystanders;
    private final Disturbance disturbance;
    private final Followers followers;
    private final ExpectedHits expectedHits;

    /** Paths under forces that vary along the path; null if there are none. */
    private final Course course;

    /** Whether impacts are predicted; if not, what may meet within the step is in piles. */
    private final boolean isInTime;

    private final Roster roster;
    private final ImpactQueue queue;
    private final TimeOfImpact timeOfImpact = new TimeOfImpact();
    private final Motion motionA = new Motion();
    private final Motion motionB = new Motion();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    /** Pairs whose impacts happen at the present time. */
    private int[] tied = new int[16];

    private int tiedCount;

    /** Flight at an accuracy; {@code course} is null where no path has to be integrated. */
    public Flight(
            DataStorage data,
            Narrowphase narrowphase,
            Broadphase broadphase,
            Accuracy accuracy,
            Course course) {
        bodies = data.bodies;
        pairs = data.pairs;
        roster = data.roster;
        counters = data.counters;
        waking = new Waking(data);
        this.narrowphase = narrowphase;
        this.broadphase = broadphase;
        this.accuracy = accuracy;
        this.course = course;
        isInTime = accuracy.impacts() == ImpactMode.EVENTS;
        free = new FreeFlight(data, course);
        paths = free.paths;
        queue = new ImpactQueue(pairs);
        impacts = new FlightImpacts(data, narrowphase, accuracy, paths, course);
        bystanders = new Bystanders(data, narrowphase, broadphase, paths, accuracy);
        expectedHits = new ExpectedHits(data, paths);
        disturbance = new Disturbance(data, paths, bystanders, waking, this::join);
        followers =
                new Followers(data, paths, bystanders, waking, expectedHits, this::join, accuracy);
    }

    /** Moves every flyer to the end of a step of {@code dt} seconds, impact by impact. */
    public void fly(double dt) {
        if (roster.awakeCount == 0) {
            // A world that sleeps is not even cleared: it may hold any number of bodies.
            return;
        }
        paths.begin();
        queue.clear(pairs.bodyA.length);
        reserve();
        disturbance.begin();
        for (int i = 0; isInTime && i < pairs.activeCount; i++) {
            int pair = pairs.active[i];
            if (pairs.points[pair] > 0 || mayMeetLater(pair)) {
                predict(pair, 0, dt);
            }
        }
        followers.join(dt);
        disturbance.spreadBouncers(dt);
        while (!queue.isEmpty()) {
            double time = queue.firstTime();
            takeTies();
            strikeTies(time, dt);
        }
        free.finish(dt);
        narrowphase.leaveOutInner(dt);
    }

    /**
     * Whether a pair without points may get some within the step. The edge of a chain has none
     * until a body is above it; a part has none where it lies in a seam of its own body, until the
     * body has turned.
     */
    private boolean mayMeetLater(int pair) {
        return narrowphase.isOneSided(pair)
                || bodies.turns()
                        && (turnsInParts(pairs.bodyA[pair]) || turnsInParts(pairs.bodyB[pair]));
    }

    private boolean turnsInParts(int body) {
        return bodies.nextShapeOf(body) != Pairs.NONE && bodies.spin[body] != 0;
    }

    /** Makes a bystander part of a pile. */
    private void join(int flyer, int pileBody, double time, double dt) {
        impacts.bring(flyer, time);
        paths.land(flyer, time);
        repredict(flyer, time, dt);
        for (int p = bodies.firstPair[flyer]; p != Pairs.NONE; p = pairs.nextOf(p, flyer)) {
            if (pairs.points[p] > 0 && !paths.isFlyer(pairs.other(p, flyer))) {
                waking.wakeWhatIsHit(p, dt - time);
                expectedHits.expect(p, time, 0, dt);
            }
        }
    }

    /**
     * Predicts the impact of a pair with a flyer between a time and the end of the step. A pair of
     * flyers that reached the limit of impacts waits for the next step; a pile does not wait.
     */
    private void predict(int pair, double from, double dt) {
        queue.remove(pair);
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        boolean isFlown = paths.isFlyer(a) || paths.isFlyer(b);
        if (!isInTime || !isFlown || waits(pair)) {
            return;
        }
        double time = meetingTime(pair, from, dt);
        if (time <= dt) {
            queue.put(pair, time);
        }
    }

    /** First time in s, from {@code from} to {@code until}, at which the two of a pair meet. */
    private double meetingTime(int pair, double from, double until) {
        boolean isOneSided = narrowphase.isOneSided(pair);
        if (isOneSided && passes(pair, from)) {
            return TimeOfImpact.NEVER;
        }
        paths.load(pairs.bodyA[pair], motionA);
        paths.load(pairs.bodyB[pair], motionB);
        motionA.outline = bodies.outline[pairs.shapeA(pair)];
        motionB.outline = bodies.outline[pairs.shapeB(pair)];
        double time =
                timeOfImpact.find(
                        motionA,
                        motionB,
                        from,
                        until,
                        accuracy.impactTolerance(),
                        accuracy.search());
        counters.evaluations += timeOfImpact.evaluations;
        return isOneSided && time <= until ? firstThatIsMet(pair, time, until) : time;
    }

    /** Time in s in which the two move by {@link #LOOK_AHEAD} against each other. */
    private double lookAhead() {
        double speed =
                Math.abs(motionA.velocityX - motionB.velocityX)
                        + Math.abs(motionA.velocityY - motionB.velocityY)
                        + Math.abs(motionA.spin) * motionA.outline.boundingRadius()
                        + Math.abs(motionB.spin) * motionB.outline.boundingRadius();
        double width = Math.min(motionA.outline.smallestWidth(), motionB.outline.smallestWidth());
        return LOOK_AHEAD * width / speed;
    }

    private boolean passes(int pair, double time) {
        paths.poseAt(pairs.bodyA[pair], time, poseA);
        paths.poseAt(pairs.bodyB[pair], time, poseB);
        return narrowphase.isPassing(pair, poseA, poseB);
    }

    /**
     * Time of impact of a one-sided pair, which may be later than the one found. Where two edges of
     * a chain meet, a body strikes one of them, if any; for the other edge the search restarts.
     */
    private double firstThatIsMet(int pair, double found, double dt) {
        double time = found;
        for (int look = 0; look < MOST_LOOKS && time <= dt; look++) {
            motionA.poseAt(time, poseA);
            motionB.poseAt(time, poseB);
            if (narrowphase.touches(pair, poseA, poseB)) {
                return time;
            }
            double next = time + lookAhead();
            time =
                    next < dt
                            ? timeOfImpact.find(
                                    motionA,
                                    motionB,
                                    next,
                                    dt,
                                    accuracy.impactTolerance(),
                                    accuracy.search())
                            : TimeOfImpact.NEVER;
            counters.evaluations += timeOfImpact.evaluations;
        }
        return TimeOfImpact.NEVER;
    }

    private boolean waits(int pair) {
        return impacts.isExhausted(pair)
                && !hitsPile(pairs.bodyA[pair])
                && !hitsPile(pairs.bodyB[pair]);
    }

    /** Grows the arrays to the present number of pairs, which can grow within the step. */
    private void reserve() {
        queue.reserve(pairs.bodyA.length);
        impacts.reserve();
    }

    /**
     * Takes the earliest impact from the queue, with all simultaneous ones that are connected to it
     * through dynamic bodies. Other simultaneous impacts are resolved separately.
     */
    private void takeTies() {
        reserve();
        double until = queue.firstTime() + TIE_PER_METRE * accuracy.impactTolerance();
        tiedCount = 0;
        tie(queue.first());
        for (int i = 0; i < tiedCount; i++) {
            takeTiesOf(pairs.bodyA[tied[i]], until);
            takeTiesOf(pairs.bodyB[tied[i]], until);
        }
    }

    private void tie(int pair) {
        if (tiedCount == tied.length) {
            tied = Arrays.copyOf(tied, 2 * tiedCount);
        }
        tied[tiedCount++] = pair;
        queue.remove(pair);
    }

    private void takeTiesOf(int slot, double until) {
        if (!bodies.isDynamic(slot)) {
            return;
        }
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            if (queue.timeOf(p) <= until) {
                tie(p);
            }
        }
    }

    /** Lets flyers that hit a pile join it, and resolves the other impacts. */
    private void strikeTies(double time, double dt) {
        int first = tied[0];
        int left = 0;
        for (int i = 0; i < tiedCount; i++) {
            if (!joinsPile(tied[i], time, dt)) {
                tied[left++] = tied[i];
            }
        }
        impacts.strike(tied, left, first, time, dt);
        for (int i = 0; i < left; i++) {
            landBeforeNext(pairs.bodyA[tied[i]], tied[i], time);
            landBeforeNext(pairs.bodyB[tied[i]], tied[i], time);
        }
        for (int i = 0; i < left; i++) {
            repredict(pairs.bodyA[tied[i]], time, dt);
            repredict(pairs.bodyB[tied[i]], time, dt);
            disturbance.noteBouncersOf(pairs.bodyA[tied[i]], dt - time);
            disturbance.noteBouncersOf(pairs.bodyB[tied[i]], dt - time);
        }
        disturbance.spread(time, dt);
    }

    /**
     * Lets a disc that was to go on to the end of its invisible bounces join its pile at once, if
     * it would meet a wall or a body of a pile before. A flyer that meets it joins it there.
     *
     * @param landing the pair whose bounces end, at a time in s
     */
    private void landBeforeNext(int slot, int landing, double time) {
        double lands = hitsPile(slot) ? bodies.pileTimeOf(slot) : 0;
        if (lands <= time) {
            return;
        }
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            boolean flies = paths.isFlyer(pairs.other(p, slot));
            if (p != landing && !flies && meetingTime(p, time, lands) < lands) {
                paths.landEarlier(slot, time);
                return;
            }
        }
    }

    private boolean joinsPile(int pair, double time, double dt) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        boolean isPileA = hitsPile(a);
        if (!isPileA && !hitsPile(b)) {
            return false;
        }
        int flyer = isPileA ? b : a;
        // A flyer that hits several bodies at once has joined at the first of them.
        if (paths.isFlyer(flyer)) {
            impacts.meet(pair, time);
            joinPile(flyer, isPileA ? a : b, pair, time, dt);
        }
        return true;
    }

    private boolean hitsPile(int slot) {
        return bodies.isDynamic(slot) && !paths.isFlyer(slot);
    }

    /** Makes a flyer that hits a pile part of it; the pile's solver resolves the impact. */
    private void joinPile(int flyer, int pileBody, int pair, double time, double dt) {
        if (!bodies.awake[pileBody]) {
            waking.wakeIntoPile(pileBody);
        }
        paths.landEarlier(pileBody, time);
        paths.land(flyer, time);
        Impact impact = impacts.expectedImpact(pair);
        impacts.foretell(pair, impact, time);
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        bystanders.measureImpact(a, b, impact, a == pileBody, dt - time);
        impacts.expectRebound(pair, flyer);
        pairs.impacts[pair] += impacts.touches(pair) ? 1 : 0;
        repredict(flyer, time, dt);
        disturbance.note(a, bystanders.reachOfA);
        disturbance.note(b, bystanders.reachOfB);
        disturbance.spread(time, dt);
    }

    /**
     * Predicts the impacts of a body whose path changed; for a body that joined a pile, measures
     * its contacts there.
     */
    private void repredict(int slot, double time, double dt) {
        if (!bodies.isDynamic(slot)) {
            return;
        }
        if (course != null && paths.isFlyer(slot) && !paths.stands(slot)) {
            course.lay(slot, time, dt);
        }
        broadphase.follow(slot, dt - time);
        reserve();
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            int other = pairs.other(p, slot);
            if (!paths.isFlyer(slot) && !paths.isFlyer(other)) {
                queue.remove(p);
                remeasure(p, time, dt);
            } else {
                predict(p, time, dt);
            }
        }
    }

    /**
     * Measures a pair of two piled bodies at their poses at a time, for the solver of piles. A rod
     * that hovered over others with one end may be pressed down at the other one within the step.
     */
    private void remeasure(int pair, double time, double dt) {
        paths.poseAt(pairs.bodyA[pair], time, poseA);
        paths.poseAt(pairs.bodyB[pair], time, poseB);
        double reach = narrowphase.reachIfHeld(pair, dt - time);
        narrowphase.measureContact(pair, poseA, poseB, reach);
    }
}
