package rigibo.backend.flight;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.collision.distance.Motion;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.impact.Impact;
import rigibo.backend.impact.ImpactLaw;
import rigibo.backend.impact.TiedImpacts;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Hits;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Quarantine;

/** Resolves the impacts of flyers: they rebound, or their series of bounces ends. */
final class FlightImpacts {

    /** Factor on the limit of impacts for two dynamic bodies with an elasticity of 1. */
    private static final int CHATTER = 16;

    private final DataStorage data;
    private final Bodies bodies;
    private final Pairs pairs;
    private final Counters counters;
    private final Narrowphase narrowphase;
    private final Accuracy accuracy;
    private final Trajectories paths;

    /** Paths under forces that vary along the path; null if there are none. */
    private final Course course;

    private final ImpactLaw law = new ImpactLaw();
    private final Impact impact = new Impact();
    private final ImpactOfParts ofParts;
    private final TiedImpacts together;
    private final Quarantine quarantine;
    private final Hits hits;
    private final Motion motionA = new Motion();
    private final Motion motionB = new Motion();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    /** By body: number of simultaneous impacts it takes part in; 0 between impacts. */
    private int[] meetings = new int[16];

    /** By simultaneous impact: time at which the pair comes to rest, s after the step's start. */
    private double[] restsAt = new double[16];

    FlightImpacts(
            DataStorage data,
            Narrowphase narrowphase,
            Accuracy accuracy,
            Trajectories paths,
            Course course) {
        this.data = data;
        bodies = data.bodies;
        pairs = data.pairs;
        counters = data.counters;
        this.narrowphase = narrowphase;
        ofParts = new ImpactOfParts(bodies, pairs, narrowphase);
        this.accuracy = accuracy;
        this.paths = paths;
        this.course = course;
        together = new TiedImpacts(bodies, pairs);
        quarantine = new Quarantine(data);
        hits = data.noteHits();
    }

    /**
     * Resolves simultaneous impacts, together where they share a body. The time is exactly that of
     * the pair {@code first}.
     */
    void strike(int[] tied, int count, int first, double time, double dt) {
        countMeetings(tied, count, 1);
        if (restsAt.length < count) {
            restsAt = new double[2 * count];
        }
        together.clear();
        for (int i = 0; i < count; i++) {
            strike(tied[i], i, time, dt);
        }
        together.resolve();
        countMeetings(tied, count, -1);
        for (int i = 0; i < count; i++) {
            quarantine.putToRestIfUnbounded(pairs.bodyA[tied[i]]);
            quarantine.putToRestIfUnbounded(pairs.bodyB[tied[i]]);
        }
        for (int i = 0; i < count; i++) {
            // A fast body may still be apart at the common time: its impact is predicted again. If
            // the first pair does not touch, its search gave up, and the solver of piles takes
            // over.
            if (touches(tied[i])) {
                end(tied[i], time, restsAt[i], dt);
            } else if (tied[i] == first) {
                land(first, time);
            }
        }
    }

    /** Grows the arrays to all bodies. */
    void reserve() {
        if (meetings.length < bodies.type.length) {
            meetings = new int[bodies.type.length];
        }
    }

    private void countMeetings(int[] tied, int count, int by) {
        for (int i = 0; i < count; i++) {
            meetings[pairs.bodyA[tied[i]]] += by;
            meetings[pairs.bodyB[tied[i]]] += by;
        }
    }

    private void strike(int pair, int i, double time, double dt) {
        meet(pair, time);
        if (!touches(pair)) {
            return;
        }
        loadImpact(pair);
        counters.impacts++;
        pairs.impacts[pair]++;
        note(pair, impact, time);
        restsAt[i] = restsAt(pair, time, dt);
        double elasticity = restsAt[i] <= dt ? 0 : impact.elasticity;
        if (sharesBody(pair)) {
            together.add(pair, impact, elasticity);
        } else {
            law.resolve(impact, elasticity);
            impact.store(bodies, pairs, pair);
            pairs.tellImpulse(pair, impact.totalNormalImpulse());
        }
    }

    /** Records place, time and speed of an impact as a hit. */
    private void note(int pair, Impact met, double time) {
        double x = poseA.x + (met.armAX[0] + met.armAX[met.points - 1]) / 2;
        double y = poseA.y + (met.armAY[0] + met.armAY[met.points - 1]) / 2;
        hits.add(bodies, pairs, pair, x, y, -met.slowestParting(), time);
    }

    /** Records the hit of an impact at a time (s) that a pile's solver will resolve. */
    void foretell(int pair, Impact expected, double time) {
        if (touches(pair)) {
            note(pair, expected, time);
            hits.foretell(pair);
        }
    }

    /**
     * Time at which the bounces of the loaded pair end, s after the step's start; may be infinite.
     */
    private double restsAt(int pair, double time, double dt) {
        double end = time + bouncesLeft(pair);
        return isExhausted(pair) && isInvisible(pair) ? Math.min(end, dt) : end;
    }

    /** Whether a dynamic body of the pair has another simultaneous impact. */
    private boolean sharesBody(int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        return bodies.isDynamic(a) && meetings[a] > 1 || bodies.isDynamic(b) && meetings[b] > 1;
    }

    /**
     * Whether a pair has reached the limit of impacts in a step. The limit is higher for two
     * dynamic bodies with an elasticity of 1, which cannot wait for the next step: the corner of a
     * turning body can strike a face a hundred times in a step, and the solver of piles would take
     * that energy.
     */
    boolean isExhausted(int pair) {
        boolean isChatter = pairs.elasticityOf(pair) == 1 && bothMove(pair);
        int most = accuracy.maxImpactsPerPair();
        return pairs.impacts[pair] >= (isChatter ? CHATTER * most : most);
    }

    private boolean isInvisible(int pair) {
        double width = PairTolerances.width(bodies, pairs.bodyA[pair], pairs.bodyB[pair]);
        double pressing = relativePressing(pair);
        return pressing > 0
                && -impact.slowestParting() <= PairTolerances.restSpeed(pressing, width);
    }

    /**
     * Ends the bounces of a pair within this step, if their series is over or the limit is reached.
     * A pair that is too fast to rest is left to the solver of piles or, at a wall with an
     * elasticity of 1, waits for the next step.
     */
    private void end(int pair, double time, double restsAt, double dt) {
        if (isExhausted(pair)) {
            counters.cappedPairs++;
        } else if (restsAt <= dt) {
            counters.settledPairs++;
        }
        if (restsAt <= dt) {
            endBounces(pair, time, restsAt);
        } else if (isExhausted(pair) && !mayWait(pair)) {
            land(pair, time);
        } else if (isExhausted(pair) || meetsStanding(pair)) {
            stand(pair, time);
        }
    }

    /**
     * Whether a pair may wait for the next step. A body with an elasticity of 1 at a wall may. Two
     * dynamic bodies may not, since their common centre of mass would have to move on meanwhile.
     */
    private boolean mayWait(int pair) {
        return pairs.elasticityOf(pair) == 1 && !bothMove(pair);
    }

    private boolean bothMove(int pair) {
        return bodies.isDynamic(pairs.bodyA[pair]) && bodies.isDynamic(pairs.bodyB[pair]);
    }

    private boolean meetsStanding(int pair) {
        return paths.stands(pairs.bodyA[pair]) || paths.stands(pairs.bodyB[pair]);
    }

    /**
     * Lets both bodies wait until the step ends, with the velocities after their impact. The solver
     * of piles would bring them to rest, which impacts without loss never do; waiting costs such a
     * pair time but no energy. A driven body does not wait, so its pair goes to the solver of
     * piles.
     */
    private void stand(int pair, double time) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        if (bodies.isDriven(a) || bodies.isDriven(b)) {
            land(pair, time);
        } else {
            paths.stand(a);
            paths.stand(b);
        }
    }

    private void land(int pair, double time) {
        paths.land(pairs.bodyA[pair], time);
        paths.land(pairs.bodyB[pair], time);
    }

    /** Whether a pair touched when it was last measured. */
    boolean touches(int pair) {
        return pairs.points[pair] > 0;
    }

    /**
     * Predicts that a body which hit a pile rebounds as from a wall. A pile yields, so the body is
     * no faster in fact and meets followers no later than predicted.
     */
    void expectRebound(int pair, int lander) {
        if (!touches(pair)) {
            return;
        }
        expectedImpact(pair);
        ofParts.widen(impact, pair, poseA, poseB, nearest(pair));
        if (pairs.bodyA[pair] == lander) {
            impact.inverseMassB = 0;
            impact.inverseInertiaB = 0;
            law.resolve(impact);
            expect(lander, impact.velocityAX, impact.velocityAY, impact.spinA);
        } else {
            impact.inverseMassA = 0;
            impact.inverseInertiaA = 0;
            law.resolve(impact);
            expect(lander, impact.velocityBX, impact.velocityBY, impact.spinB);
        }
    }

    /** Sets the predicted velocity, unless it is not finite; then the old velocity is kept. */
    private void expect(int lander, double velocityX, double velocityY, double spin) {
        if (Quarantine.isBounded(velocityX)
                && Quarantine.isBounded(velocityY)
                && Quarantine.isBounded(spin)) {
            paths.expect(lander, velocityX, velocityY, spin);
        }
    }

    /** The impact of a pair that has met, at the predicted velocities of both. */
    Impact expectedImpact(int pair) {
        loadImpact(pair);
        impact.velocityAX = motionA.velocityX;
        impact.velocityAY = motionA.velocityY;
        impact.spinA = motionA.spin;
        impact.velocityBX = motionB.velocityX;
        impact.velocityBY = motionB.velocityY;
        impact.spinB = motionB.spin;
        return impact;
    }

    /** Advances both bodies to the time of their impact and measures their contact. */
    void meet(int pair, double time) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        bring(a, time);
        bring(b, time);
        if (data.ways != null) {
            note(a, time);
            note(b, time);
        }
        paths.load(a, motionA);
        paths.load(b, motionB);
        motionA.poseAt(time, poseA);
        motionB.poseAt(time, poseB);
        double width = PairTolerances.width(bodies, a, b);
        narrowphase.measure(pair, poseA, poseB, PairTolerances.TOUCHING_GAP * width);
    }

    /** Starts a new path of a flyer at a time, s. */
    private void note(int slot, double time) {
        if (paths.isFlyer(slot)) {
            data.ways.note(bodies, slot, time);
        }
    }

    /** Advances a flyer's columns to a time, s after the step's start. */
    void bring(int slot, double time) {
        if (paths.isFlyer(slot)) {
            paths.advance(slot, time);
            if (course != null) {
                course.catchUp(slot, time);
            }
        }
    }

    /** Loads the points that touch: those that are as near as the nearest within the tolerance. */
    private void loadImpact(int pair) {
        impact.load(bodies, pairs, pair);
        double nearest = nearest(pair);
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

    /** Gap up to which a point of a pair that has met takes part in the impact, m. */
    private double nearest(int pair) {
        double width = PairTolerances.width(bodies, pairs.bodyA[pair], pairs.bodyB[pair]);
        return pairs.gap(pair) + accuracy.impactTolerance() * width;
    }

    /**
     * Duration in s of all bounces still to come: Zeno's series 2ev/(a(1 − e)) for an approach at
     * speed v with a pressing acceleration a; infinite if nothing presses or e = 1.
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

    /** Closing acceleration of A and B along the normal, m/s². */
    private double relativePressing(int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double ax = accelerationX(a) - accelerationX(b);
        double ay = accelerationY(a) - accelerationY(b);
        return PairTolerances.along(ax, ay, pairs.normalX[pair], pairs.normalY[pair]);
    }

    private double accelerationX(int slot) {
        return paths.isFlyer(slot) ? bodies.accelerationX[slot] : 0;
    }

    private double accelerationY(int slot) {
        return paths.isFlyer(slot) ? bodies.accelerationY[slot] : 0;
    }

    /**
     * Ends a series of bounces, after which the bodies rest on each other. A disc moves on during
     * its last, invisible bounces; other shapes would also turn, so they rest at once.
     */
    private void endBounces(int pair, double time, double end) {
        pairs.resting[pair] = true;
        pairs.touching[pair] = true;
        settle(pairs.bodyA[pair], time, end);
        settle(pairs.bodyB[pair], time, end);
    }

    private void settle(int slot, double time, double end) {
        if (!paths.isFlyer(slot)) {
            return;
        }
        double when = bodies.isCentredDisc(slot) ? end : time;
        double elapsed = when - time;
        bodies.x[slot] += elapsed * bodies.velocityX[slot];
        bodies.y[slot] += elapsed * bodies.velocityY[slot];
        if (bodies.spinOf(slot) != 0) {
            bodies.turn(slot, elapsed * bodies.spinOf(slot));
        }
        paths.land(slot, when);
    }
}
