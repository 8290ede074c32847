package rigibo.backend.flight;

import rigibo.backend.collision.Motion;
import rigibo.backend.collision.Narrowphase;
import rigibo.backend.collision.Pose;
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

/** What happens when flyers meet: they part again, or their bounces have come to an end. */
final class FlightImpacts {

    /** Factor by which two that both move and lose nothing may meet more often in a step. */
    private static final int CHATTER = 16;

    private final DataStorage data;
    private final Bodies bodies;
    private final Pairs pairs;
    private final Counters counters;
    private final Narrowphase narrowphase;
    private final Accuracy accuracy;
    private final Trajectories paths;

    /** Paths under forces that change along the way, or null where there are none. */
    private final Course course;

    private final ImpactLaw law = new ImpactLaw();
    private final Impact impact = new Impact();
    private final TiedImpacts together;
    private final Quarantine quarantine;
    private final Hits hits;
    private final Motion motionA = new Motion();
    private final Motion motionB = new Motion();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    /** For each body in how many of the pairs of this instant it is; 0 between instants. */
    private int[] meetings = new int[16];

    /** For each pair of this instant when it rests, s after the step's start. */
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
        this.accuracy = accuracy;
        this.paths = paths;
        this.course = course;
        together = new TiedImpacts(bodies, pairs);
        quarantine = new Quarantine(data);
        hits = data.noteHits();
    }

    /**
     * Resolves the impacts of one instant, at once where they share a body; of the first of them
     * the time is exact.
     */
    void strike(int[] tied, int count, int first, double time, double dt) {
        countMeetings(tied, count, 1);
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
            // What is fast may be far yet though it meets within the same instant: it is looked for
            // anew. If the first has not met, the search for it has given up, and the pile goes on.
            if (touches(tied[i])) {
                end(tied[i], time, restsAt[i], dt);
            } else if (tied[i] == first) {
                land(first, time);
            }
        }
    }

    /** Makes room for as many pairs at one instant, and for all bodies. */
    void reserve(int pairCapacity) {
        if (restsAt.length < pairCapacity) {
            restsAt = new double[pairCapacity];
        }
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

    /** Notes where, when and how fast the two of a loaded impact meet. */
    private void note(int pair, Impact met, double time) {
        double x = poseA.x + (met.armAX[0] + met.armAX[met.points - 1]) / 2;
        double y = poseA.y + (met.armAY[0] + met.armAY[met.points - 1]) / 2;
        hits.add(bodies, pairs, pair, x, y, -met.slowestParting(), time);
    }

    /** Notes an impact whose outcome a pile's solver will find, at a time in s. */
    void foretell(int pair, Impact expected, double time) {
        if (touches(pair)) {
            note(pair, expected, time);
            hits.foretell(pair);
        }
    }

    /** When the bounces of the pair whose impact is loaded have ended, s; infinite if not yet. */
    private double restsAt(int pair, double time, double dt) {
        double end = time + bouncesLeft(pair);
        return isExhausted(pair) && isInvisible(pair) ? Math.min(end, dt) : end;
    }

    /** What is not dynamic passes nothing on. */
    private boolean sharesBody(int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        return bodies.isDynamic(a) && meetings[a] > 1 || bodies.isDynamic(b) && meetings[b] > 1;
    }

    /**
     * Whether a pair has met as often as it may in a step. What loses nothing and cannot wait for
     * the next step may chatter on: the corner of a body that turns against a face parts with it a
     * hundred times, and a pile would take the energy of that.
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
     * Ends the bounces of a pair for this step. It rests once they are over. A pair that could
     * bounce on for ever, too fast to rest, is left to the solver of piles, or stands at a wall
     * where nothing may be lost.
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
     * Whether a pair may wait for the next step. At a wall what loses nothing may; two that both
     * move would have to go on with their common centre of mass meanwhile, so they are left to the
     * pile.
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
     * Both stand until the step ends, with the speeds they parted with. No number of impacts
     * without loss brings a pair to rest, as a solver of piles would; so such a pair loses time,
     * but no energy. What is driven does not wait: the pile has to give way to it.
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

    /** Whether a pair touched where it was last measured: one that has met does. */
    boolean touches(int pair) {
        return pairs.points[pair] > 0;
    }

    /**
     * Expects a body that has met a pile to rebound as from a wall. A pile gives way rather than
     * pushes, so that whatever follows behind is met no later than expected.
     */
    void expectRebound(int pair, int lander) {
        if (!touches(pair)) {
            return;
        }
        expectedImpact(pair);
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

    /** What would be beyond all bounds is not expected: the body goes on as it came. */
    private void expect(int lander, double velocityX, double velocityY, double spin) {
        if (Quarantine.isBounded(velocityX)
                && Quarantine.isBounded(velocityY)
                && Quarantine.isBounded(spin)) {
            paths.expect(lander, velocityX, velocityY, spin);
        }
    }

    /** The impact of a pair that has met, at the velocities that both are expected to have. */
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

    /** Brings both bodies to the time of their impact and finds where they touch. */
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

    /** What flew here flies on another way. */
    private void note(int slot, double time) {
        if (paths.isFlyer(slot)) {
            data.ways.note(bodies, slot, time);
        }
    }

    /** Brings a body's columns to a time in s, if it flies. */
    void bring(int slot, double time) {
        if (paths.isFlyer(slot)) {
            paths.advance(slot, time);
            if (course != null) {
                course.catchUp(slot, time);
            }
        }
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
        return PairTolerances.along(ax, ay, pairs.normalX[pair], pairs.normalY[pair]);
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
