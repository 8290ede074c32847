package rigibo.backend.sense;

import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.collision.distance.TimeOfImpact;
import rigibo.backend.collision.distance.Touching;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Outline;
import rigibo.backend.setup.ImpactSearch;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Visits;

/**
 * Tests every shape whose fixture overlaps a sensor's: whether it is inside the sensor, or, if it
 * is outside and was so before, whether it passed through within the step.
 */
public final class SensorStage {

    /** Largest gap on the way that counts as touching, as a share of the narrower shape's width. */
    private static final double TOLERANCE = 1e-6;

    private final DataStorage data;
    private final Broadphase broadphase;
    private final Bodies bodies;
    private final Counters counters;
    private final Touching touching = new Touching();
    private final TimeOfImpact timeOfImpact = new TimeOfImpact();
    private final Pose pose = new Pose();
    private final Pose otherPose = new Pose();
    private final Leg way;
    private final Leg otherWay;

    /** The sensors of a storage. */
    public SensorStage(DataStorage data, Broadphase broadphase) {
        this.broadphase = broadphase;
        this.data = data;
        bodies = data.bodies;
        counters = data.counters;
        way = new Leg(data);
        otherWay = new Leg(data);
    }

    /**
     * Updates all visits after a step of dt seconds, and drops those whose fixtures have parted.
     */
    public void sense(double dt) {
        Visits visits = data.visits;
        if (visits == null) {
            return;
        }
        broadphase.meetVisitors();
        int kept = 0;
        for (int i = 0; i < visits.count; i++) {
            visits.state[i] = next(visits, i, dt);
            if (visits.state[i] == Visits.OUTSIDE && isOver(visits.sensor[i], visits.visitor[i])) {
                visits.drop(i);
            } else {
                visits.keep(i, kept++);
            }
        }
        visits.count = kept;
        data.ways.count = 0;
    }

    private int next(Visits visits, int visit, double dt) {
        int sensor = visits.sensor[visit];
        int visitor = visits.visitor[visit];
        boolean wasIn = visits.isInside(visit);
        boolean meet = bodies.meet(sensor, visitor);
        boolean isIn = meet && isInside(sensor, visitor);
        if (isIn) {
            return wasIn ? Visits.INSIDE : Visits.ENTERED;
        }
        if (wasIn) {
            return Visits.LEFT;
        }
        return meet && passes(sensor, visitor, dt) ? Visits.PASSED : Visits.OUTSIDE;
    }

    /**
     * Whether the fixtures are apart or the two do not collide, so that no test is due until a
     * fixture is replaced.
     */
    private boolean isOver(int a, int b) {
        return bodies.fixtureMinX[a] > bodies.fixtureMaxX[b]
                || bodies.fixtureMinX[b] > bodies.fixtureMaxX[a]
                || bodies.fixtureMinY[a] > bodies.fixtureMaxY[b]
                || bodies.fixtureMinY[b] > bodies.fixtureMaxY[a]
                || !bodies.meet(a, b);
    }

    private boolean isInside(int sensor, int visitor) {
        counters.sensed++;
        place(sensor, pose);
        place(visitor, otherPose);
        return touching.areTouching(
                bodies.outline[sensor], pose, bodies.outline[visitor], otherPose);
    }

    private void place(int slot, Pose at) {
        int body = bodies.bodyOf(slot);
        at.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
    }

    /** Whether the two touch on their paths within the step. */
    private boolean passes(int sensor, int visitor, double dt) {
        int body = bodies.bodyOf(sensor);
        int other = bodies.bodyOf(visitor);
        if (!bodies.isMoved(body) && !bodies.isMoved(other)) {
            return false;
        }
        way.begin(sensor, dt);
        otherWay.begin(visitor, dt);
        double from = 0;
        while (true) {
            double until = Math.min(way.until, otherWay.until);
            double found =
                    timeOfImpact.find(
                            way.motion, otherWay.motion, from, until, TOLERANCE, ImpactSearch.ITP);
            if (found <= until) {
                return isMet(bodies.outline[sensor], bodies.outline[visitor], found);
            }
            if (!(until < dt)) {
                return false;
            }
            from = until;
            if (way.until == until && way.hasNext()) {
                way.advance();
            }
            if (otherWay.until == until && otherWay.hasNext()) {
                otherWay.advance();
            }
        }
    }

    /**
     * Whether an impact found on the paths is real. At an edge of a chain the search may report one
     * from behind, in the chain's matter, although the two are out of reach.
     */
    private boolean isMet(Outline sensor, Outline visitor, double time) {
        if (!sensor.isEdge() && !visitor.isEdge()) {
            return true;
        }
        way.motion.poseAt(time, pose);
        otherWay.motion.poseAt(time, otherPose);
        return touching.areWithin(2 * TOLERANCE, sensor, pose, visitor, otherPose);
    }
}
