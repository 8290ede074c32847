package rigibo.backend.flight;

import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.collision.Motion;
import rigibo.backend.collision.Narrowphase;
import rigibo.backend.collision.Pose;
import rigibo.backend.collision.TimeOfImpact;
import rigibo.backend.geometry.ShapeKind;
import rigibo.backend.impact.Impact;
import rigibo.backend.impact.ImpactLaw;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Roster;
import rigibo.backend.storage.Waking;

/**
 * Moves the bodies in flight, with their impacts in the order of time. At an impact only its two
 * bodies are brought to that time; their other impacts are predicted anew.
 */
public final class Flight {

    private final Bodies bodies;
    private final Pairs pairs;
    private final Roster roster;
    private final Counters counters;
    private final Waking waking;
    private final Narrowphase narrowphase;
    private final Broadphase broadphase;
    private final Accuracy accuracy;
    private final Trajectories paths;

    /** Paths under forces that change along the way, or null where there are none. */
    private final Course course;

    private final ImpactQueue queue = new ImpactQueue();
    private final TimeOfImpact timeOfImpact = new TimeOfImpact();
    private final ImpactLaw law = new ImpactLaw();
    private final Impact impact = new Impact();
    private final Motion motionA = new Motion();
    private final Motion motionB = new Motion();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

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
        paths = new Trajectories(bodies);
    }

    /** Moves every flyer to the end of a step of {@code dt} seconds, through everything. */
    public void fly(double dt) {
        paths.begin();
        finish(dt);
    }

    /** Moves every flyer to the end of a step of {@code dt} seconds, impact by impact. */
    public void flyWithImpacts(double dt) {
        paths.begin();
        queue.clear(pairs.bodyA.length);
        for (int i = 0; i < pairs.activeCount; i++) {
            if (pairs.points[pairs.active[i]] > 0) {
                predict(pairs.active[i], 0, dt);
            }
        }
        while (!queue.isEmpty()) {
            int pair = queue.first();
            double time = queue.firstTime();
            queue.remove(pair);
            strike(pair, time, dt);
        }
        finish(dt);
    }

    private void finish(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            if (paths.isFlyer(roster.awake[i])) {
                paths.advance(roster.awake[i], dt);
            }
        }
        if (course != null) {
            catchUp(dt);
        }
    }

    private void catchUp(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            if (paths.isFlyer(roster.awake[i])) {
                course.catchUp(roster.awake[i], dt);
            }
        }
    }

    /** Notes when a pair with a flyer hits within the step, seen from a time on. */
    private void predict(int pair, double from, double dt) {
        queue.remove(pair);
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        if (!paths.isFlyer(a) && !paths.isFlyer(b)) {
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

    private void strike(int pair, double time, double dt) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        meet(pair, time);
        if (hitsPile(a)) {
            joinPile(b, a, pair, time, dt);
        } else if (hitsPile(b)) {
            joinPile(a, b, pair, time, dt);
        } else {
            blow(pair, time, dt);
        }
    }

    private boolean hitsPile(int slot) {
        return bodies.isDynamic(slot) && !paths.isFlyer(slot);
    }

    /** Brings both bodies to the time of their impact and finds where they touch. */
    private void meet(int pair, double time) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        bring(a, time);
        bring(b, time);
        paths.load(a, motionA);
        paths.load(b, motionB);
        motionA.poseAt(time, poseA);
        motionB.poseAt(time, poseB);
        double width = PairTolerances.width(bodies, a, b);
        narrowphase.measure(pair, poseA, poseB, PairTolerances.TOUCHING_GAP * width);
    }

    private void bring(int slot, double time) {
        if (paths.isFlyer(slot)) {
            paths.advance(slot, time);
            if (course != null) {
                course.catchUp(slot, time);
            }
        }
    }

    /** A flyer that hits a pile becomes part of it; the pile's solver resolves the blow. */
    private void joinPile(int flyer, int pileBody, int pair, double time, double dt) {
        if (!bodies.awake[pileBody]) {
            waking.wakeIntoPile(pileBody);
        }
        join(flyer, time);
        pairs.impacts[pair]++;
        repredict(flyer, time, dt);
    }

    private void join(int slot, double time) {
        if (paths.isFlyer(slot)) {
            bodies.piled[slot] = true;
            bodies.pileTime[slot] = time;
        }
    }

    private void blow(int pair, double time, double dt) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        loadImpact(pair);
        counters.impacts++;
        pairs.impacts[pair]++;
        double end = impact.points == 0 ? time : time + bouncesLeft(pair);
        boolean comesToRest = end <= dt || pairs.impacts[pair] >= accuracy.maxImpactsPerPair();
        if (impact.points > 0) {
            law.resolve(impact, comesToRest ? 0 : impact.elasticity);
            impact.store(bodies, pairs, pair);
            pairs.impulse[pair] += impact.totalNormalImpulse();
        }
        if (comesToRest) {
            endBounces(pair, time, Math.min(end, dt));
        }
        repredict(a, time, dt);
        repredict(b, time, dt);
    }

    /** Takes the points that touch: those as near as the nearest, within the tolerance. */
    private void loadImpact(int pair) {
        impact.load(bodies, pairs, pair);
        double width = PairTolerances.width(bodies, pairs.bodyA[pair], pairs.bodyB[pair]);
        double nearest = pairs.gap(pair) + accuracy.impactTolerance() * width;
        for (int point = 2 * pair; point < 2 * pair + pairs.points[pair]; point++) {
            if (pairs.separation[point] <= nearest) {
                impact.addPoint(
                        pairs.pointX[point],
                        pairs.pointY[point],
                        poseA.x,
                        poseA.y,
                        poseB.x,
                        poseB.y);
            }
        }
    }

    /**
     * How long in s all bounces still to come take: Zeno's series 2ev/(a(1 − e)) for an approach at
     * speed v against an acceleration a; infinite where nothing presses or nothing is lost.
     */
    private double bouncesLeft(int pair) {
        double speed = Math.max(0, -impact.slowestParting());
        double pressing = relativePressing(pair);
        double e = impact.elasticity;
        if (!(pressing > 0)) {
            return Double.POSITIVE_INFINITY;
        }
        return e * speed == 0 ? 0 : 2 * e * speed / (pressing * (1 - e));
    }

    /** The acceleration in m/s² at which A and B close along the normal. */
    private double relativePressing(int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double ax = accelerationX(a) - accelerationX(b);
        double ay = accelerationY(a) - accelerationY(b);
        return ax * pairs.normalX[pair] + ay * pairs.normalY[pair];
    }

    private double accelerationX(int slot) {
        return paths.isFlyer(slot) ? bodies.accelerationX[slot] : 0;
    }

    private double accelerationY(int slot) {
        return paths.isFlyer(slot) ? bodies.accelerationY[slot] : 0;
    }

    /**
     * Ends a series of bounces: the bodies rest on each other from its end on. A disc slides on
     * while its last bounces go by unseen; other shapes also turn, so they rest at once.
     */
    private void endBounces(int pair, double time, double end) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        pairs.resting[pair] = true;
        pairs.touching[pair] = true;
        settle(a, time, end);
        settle(b, time, end);
    }

    private void settle(int slot, double time, double end) {
        if (!paths.isFlyer(slot)) {
            return;
        }
        double when = bodies.shape[slot].kind() == ShapeKind.CIRCLE ? end : time;
        double elapsed = when - time;
        bodies.x[slot] += elapsed * bodies.velocityX[slot];
        bodies.y[slot] += elapsed * bodies.velocityY[slot];
        if (bodies.spin[slot] != 0) {
            bodies.turn(slot, elapsed * bodies.spin[slot]);
        }
        join(slot, when);
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
        queue.reserve(pairs.bodyA.length);
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            int other = pairs.other(p, slot);
            if (!paths.isFlyer(slot) && !paths.isFlyer(other)) {
                queue.remove(p);
                remeasure(p, dt - time);
            } else {
                predict(p, time, dt);
            }
        }
    }

    /** The manifold of a pair that the pile's solver will see to, at the poses it starts from. */
    private void remeasure(int pair, double left) {
        boolean touched = pairs.touching[pair];
        narrowphase.measure(pair, left);
        pairs.touching[pair] = touched;
    }
}
