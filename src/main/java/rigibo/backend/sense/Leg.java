package rigibo.backend.sense;

import rigibo.backend.collision.distance.Motion;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Ways;

/**
 * A body's path within a step, leg by leg: from where it began, over the places where it was
 * struck, to where it is now. On a leg a body in flight follows the parabola of its acceleration
 * through both ends; a body of a pile moves in a straight line.
 */
final class Leg {

    final Motion motion = new Motion();

    /** End of the present leg, s after the step's start. */
    double until;

    private final Bodies bodies;
    private final DataStorage data;
    private int body;
    private double dt;

    /** Index of the strike that ends the leg; the number of strikes for the last leg. */
    private int next;

    private double x;
    private double y;
    private double angle;
    private double from;

    Leg(DataStorage data) {
        this.data = data;
        bodies = data.bodies;
    }

    /** Begins the path of a shape over a step of dt seconds. */
    void begin(int slot, double dt) {
        body = bodies.bodyOf(slot);
        this.dt = dt;
        motion.outline = bodies.outline[slot];
        boolean isMoved = bodies.isMoved(body);
        x = isMoved ? bodies.startX[body] : bodies.x[body];
        y = isMoved ? bodies.startY[body] : bodies.y[body];
        angle = isMoved && bodies.turns() ? bodies.startAngle[body] : bodies.angle[body];
        from = 0;
        next = -1;
        lay();
    }

    /** Goes on to the next leg. */
    void advance() {
        Ways ways = data.ways;
        x = ways.x[next];
        y = ways.y[next];
        angle = ways.angle[next];
        from = until;
        lay();
    }

    /** Whether there is another leg. */
    boolean hasNext() {
        return next < data.ways.count;
    }

    private void lay() {
        Ways ways = data.ways;
        next++;
        while (next < ways.count && !(ways.body[next] == body && ways.time[next] > from)) {
            next++;
        }
        boolean isLast = next == ways.count;
        until = isLast ? dt : ways.time[next];
        double elapsed = until - from;
        boolean flies = bodies.isDynamic(body) && bodies.awake[body] && !bodies.piled[body];
        motion.startTime = from;
        motion.x = x;
        motion.y = y;
        motion.angle = angle;
        motion.drag = 0;
        motion.angularAcceleration = 0;
        motion.accelerationX = flies ? bodies.accelerationX[body] : 0;
        motion.accelerationY = flies ? bodies.accelerationY[body] : 0;
        double toX = isLast ? bodies.x[body] : ways.x[next];
        double toY = isLast ? bodies.y[body] : ways.y[next];
        double toAngle = isLast ? bodies.angle[body] : ways.angle[next];
        double share = elapsed > 0 ? 1 / elapsed : 0;
        motion.velocityX = (toX - x) * share - motion.accelerationX * elapsed / 2;
        motion.velocityY = (toY - y) * share - motion.accelerationY * elapsed / 2;
        motion.spin = (toAngle - angle) * share;
    }
}
