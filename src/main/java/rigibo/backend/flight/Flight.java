package rigibo.backend.flight;

import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.collision.Motion;
import rigibo.backend.collision.Narrowphase;
import rigibo.backend.collision.Pose;
import rigibo.backend.collision.TimeOfImpact;
import rigibo.backend.impact.Impact;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Waking;

/**
 * Moves the bodies in flight, with their impacts in the order of time. At an impact only its two
 * bodies are brought to that time; their other impacts are predicted anew.
 */
public final class Flight {

    /**
     * Impacts this close are one instant, s per metre of the tolerance: a thousandth of what a body
     * of 1 m/s may miss the other by.
     */
    private static final double TIE_PER_METRE = 1e-3;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Counters counters;
    private final Waking waking;
    private final Narrowphase narrowphase;
    private final Broadphase broadphase;
    private final Accuracy accuracy;
    private final FreeFlight free;
    private final Trajectories paths;
    private final Blows blows;
    private final Bystanders bystanders;

    /** Those whose path is not what was expected, in the order found. */
    private final Found disturbed = new Found();

    /** Bystanders that have joined a pile, whose own blows are still to be looked at. */
    private final Found joined = new Found();

    /** For each body in which step it was last found to follow behind, and the number of this. */
    private int[] followedIn = new int[16];

    private int step;

    /** For each body in which spreading it was last disturbed, and how far it may get by it, m. */
    private int[] disturbedIn = new int[16];

    private double[] reachOf = new double[16];
    private int spreading;

    /** Paths under forces that change along the way, or null where there are none. */
    private final Course course;

    private final ImpactQueue queue;
    private final TimeOfImpact timeOfImpact = new TimeOfImpact();
    private final Motion motionA = new Motion();
    private final Motion motionB = new Motion();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    /** Pairs whose impacts fall on the instant that is looked at. */
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
        counters = data.counters;
        waking = new Waking(data);
        this.narrowphase = narrowphase;
        this.broadphase = broadphase;
        this.accuracy = accuracy;
        this.course = course;
        free = new FreeFlight(data, course);
        paths = free.paths;
        queue = new ImpactQueue(pairs);
        blows = new Blows(data, narrowphase, accuracy, paths, course);
        bystanders =
                new Bystanders(data, narrowphase, broadphase, paths, accuracy.impactTolerance());
    }

    /** Moves every flyer to the end of a step of {@code dt} seconds, impact by impact. */
    public void fly(double dt) {
        paths.begin();
        queue.clear(pairs.bodyA.length);
        reserve();
        step++;
        if (followedIn.length < bodies.type.length) {
            followedIn = new int[bodies.type.length];
            disturbedIn = new int[bodies.type.length];
            reachOf = new double[bodies.type.length];
        }
        disturbed.clear();
        disturbed.reserve(bodies.type.length + 1);
        joined.clear();
        joined.reserve(bodies.type.length);
        for (int i = 0; i < pairs.activeCount; i++) {
            if (pairs.points[pairs.active[i]] > 0) {
                predict(pairs.active[i], 0, dt);
            }
        }
        disturbBouncers(dt);
        while (!queue.isEmpty()) {
            double time = queue.firstTime();
            takeTies();
            strikeTies(time, dt);
        }
        free.finish(dt);
    }

    private void disturbBouncers(double dt) {
        int count = pairs.activeCount;
        for (int i = 0; i < count; i++) {
            if (pairs.points[pairs.active[i]] > 0) {
                disturbBouncers(pairs.active[i], 0, dt);
            }
        }
    }

    private void disturbBouncers(int pair, double time, double dt) {
        spreadBouncers(pair, time, dt);
        disturbJoined(time, dt);
    }

    private void spreadBouncers(int pair, double time, double dt) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        if (!paths.isFlyer(a) && !paths.isFlyer(b)) {
            double reach = bystanders.reachOfBouncers(pair, dt - time);
            spread(a, reach, time, dt);
            spread(b, reach, time, dt);
        }
    }

    /** Lets join what a body of a pile may reach from a time on, and what that strikes reaches. */
    private void disturb(int slot, double reach, double time, double dt) {
        spread(slot, reach, time, dt);
        disturbJoined(time, dt);
    }

    /**
     * A fast flyer that joins for a slow neighbour's sake strikes it all the same, and what it
     * strikes goes farther than the neighbour would have gone by itself.
     */
    private void disturbJoined(double time, double dt) {
        while (joined.count > 0) {
            int slot = joined.numbers[--joined.count];
            for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
                if (pairs.points[p] > 0) {
                    spreadBouncers(p, time, dt);
                }
            }
        }
    }

    /**
     * What a body of a pile may reach from a time on becomes part of the pile, or a contact; and so
     * does what that may reach in its turn, or what follows close behind. A way is used up by the
     * gaps on it: who is reached late is not pushed far any more.
     */
    private void spread(int slot, double reach, double time, double dt) {
        if (!hitsPile(slot) || !bodies.awake[slot]) {
            return;
        }
        disturbed.clear();
        spreading++;
        note(slot, reach);
        for (int i = 0; i < disturbed.count; i++) {
            disturbNeighbours(disturbed.numbers[i], time, dt);
        }
    }

    /** A reach of 0 surprises nobody. */
    private void note(int slot, double reach) {
        disturbedIn[slot] = spreading;
        reachOf[slot] = reach;
        if (reach > 0) {
            disturbed.add(slot);
        }
    }

    private void disturbNeighbours(int slot, double time, double dt) {
        double reach = reachOf[slot];
        bystanders.lookRound(slot, time, reach);
        reserve();
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            int other = pairs.other(p, slot);
            boolean flies = paths.isFlyer(other);
            if (!flies && pairs.points[p] > 0) {
                passOn(p, other, reach, time, dt);
            } else if (bystanders.isWithinReach(p, reach, time, dt - time) && flies) {
                double left = bystanders.reachLeft(p, other, reach, dt);
                join(other, time, dt);
                note(other, left);
            }
        }
    }

    private void join(int flyer, double time, double dt) {
        blows.bring(flyer, time);
        paths.land(flyer, time);
        repredict(flyer, time, dt);
        joined.add(flyer);
    }

    /** Over a contact of the pile: to what follows, and to what was reached by a longer way. */
    private void passOn(int pair, int other, double reach, double time, double dt) {
        boolean isKnown = disturbedIn[other] == spreading;
        boolean follows = followedIn[other] != step && bystanders.goesAlong(other, dt - time);
        if (follows || isKnown) {
            double left = bystanders.reachLeft(pair, other, reach, dt);
            if (!isKnown || left > reachOf[other]) {
                followedIn[other] = step;
                note(other, left);
            }
        }
    }

    /**
     * Notes when a pair with a flyer hits within the step, seen from a time on. A pair that has met
     * as often as it may is left to the next step.
     */
    private void predict(int pair, double from, double dt) {
        queue.remove(pair);
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        boolean isExhausted = pairs.impacts[pair] >= accuracy.maxImpactsPerPair();
        if (isExhausted || !paths.isFlyer(a) && !paths.isFlyer(b)) {
            return;
        }
        paths.load(a, motionA);
        paths.load(b, motionB);
        double time =
                timeOfImpact.find(
                        motionA, motionB, from, dt, accuracy.impactTolerance(), accuracy.search());
        counters.evaluations += timeOfImpact.evaluations;
        if (time <= dt) {
            queue.put(pair, time);
        }
    }

    /** Makes room for an instant at which all pairs meet. */
    private void reserve() {
        int pairCapacity = pairs.bodyA.length;
        queue.reserve(pairCapacity);
        if (tied.length < pairCapacity) {
            tied = new int[pairCapacity];
        }
        blows.reserve(pairCapacity);
    }

    /**
     * Takes the earliest impact from the queue, and all that fall on the same instant and hang
     * together with it by bodies that pass something on: strangers' impacts are none of its matter.
     */
    private void takeTies() {
        double until = queue.firstTime() + TIE_PER_METRE * accuracy.impactTolerance();
        tied[0] = queue.first();
        tiedCount = 1;
        queue.remove(tied[0]);
        for (int i = 0; i < tiedCount; i++) {
            takeTiesOf(pairs.bodyA[tied[i]], until);
            takeTiesOf(pairs.bodyB[tied[i]], until);
        }
    }

    private void takeTiesOf(int slot, double until) {
        if (!bodies.isDynamic(slot)) {
            return;
        }
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            if (queue.timeOf(p) <= until) {
                tied[tiedCount++] = p;
                queue.remove(p);
            }
        }
    }

    /** Flyers that hit a pile join it; the others strike each other, alone or together. */
    private void strikeTies(double time, double dt) {
        int left = 0;
        for (int i = 0; i < tiedCount; i++) {
            if (!joinsPile(tied[i], time, dt)) {
                tied[left++] = tied[i];
            }
        }
        blows.strike(tied, left, time, dt);
        for (int i = 0; i < left; i++) {
            repredict(pairs.bodyA[tied[i]], time, dt);
            repredict(pairs.bodyB[tied[i]], time, dt);
            disturbBouncers(tied[i], time, dt);
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
        // One that hits several at once has joined by the first of them.
        if (paths.isFlyer(flyer)) {
            blows.meet(pair, time);
            joinPile(flyer, isPileA ? a : b, pair, time, dt);
        }
        return true;
    }

    private boolean hitsPile(int slot) {
        return bodies.isDynamic(slot) && !paths.isFlyer(slot);
    }

    /** A flyer that hits a pile becomes part of it; the pile's solver resolves the blow. */
    private void joinPile(int flyer, int pileBody, int pair, double time, double dt) {
        if (!bodies.awake[pileBody]) {
            waking.wakeIntoPile(pileBody);
        }
        paths.landEarlier(pileBody, time);
        paths.land(flyer, time);
        Impact blow = blows.expectedBlow(pair);
        int a = pairs.bodyA[pair];
        double reach = bystanders.reachOfBlow(a, pairs.bodyB[pair], blow, dt - time);
        blows.expectRebound(pair, flyer);
        pairs.impacts[pair]++;
        repredict(flyer, time, dt);
        disturb(pileBody, reach, time, dt);
        disturb(flyer, reach, time, dt);
    }

    /**
     * Predicts the impacts of a body whose path changed; one that joined a pile meets its pairs.
     */
    private void repredict(int slot, double time, double dt) {
        if (!bodies.isDynamic(slot)) {
            return;
        }
        if (course != null && paths.isFlyer(slot)) {
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

    /** The manifold of a pair that the pile's solver will see to, where its bodies are by then. */
    private void remeasure(int pair, double time, double dt) {
        paths.poseAt(pairs.bodyA[pair], time, poseA);
        paths.poseAt(pairs.bodyB[pair], time, poseB);
        double reach = narrowphase.reach(pair, dt - time);
        narrowphase.measureContact(pair, poseA, poseB, reach);
    }
}
