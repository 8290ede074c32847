package rigibo.backend.flight;

import rigibo.backend.collision.distance.Motion;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Roster;

/** Moves every body along its exact path through all others, in pools without contacts. */
public final class OpenFlight {

    private final Bodies bodies;
    private final Roster roster;
    private final Motion motion = new Motion();

    /** Paths under forces that vary along the path; null if there are none. */
    private final Course course;

    /** Turning of the bodies; null without rotation. */
    private final OpenTurning turning;

    /** Open flight; {@code course} is null where no path has to be integrated. */
    public OpenFlight(DataStorage data, Course course) {
        bodies = data.bodies;
        turning = bodies.turns() ? new OpenTurning(data) : null;
        roster = data.roster;
        this.course = course;
    }

    /** Moves every dynamic body by a step of {@code dt} seconds. */
    public void fly(double dt) {
        if (bodies.drag == null) {
            flyFreely(dt);
        } else {
            flyThroughDrag(dt);
        }
        if (turning != null) {
            turning.turn(dt);
        }
        if (course != null) {
            catchUp(dt);
        }
    }

    /** Moves every body along its parabola. */
    private void flyFreely(double dt) {
        double half = dt * dt / 2;
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDynamic(slot)) {
                double ax = bodies.accelerationX[slot];
                double ay = bodies.accelerationY[slot];
                bodies.x[slot] += bodies.velocityX[slot] * dt + ax * half;
                bodies.y[slot] += bodies.velocityY[slot] * dt + ay * half;
                bodies.velocityX[slot] += ax * dt;
                bodies.velocityY[slot] += ay * dt;
            }
        }
    }

    private void flyThroughDrag(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDynamic(slot)) {
                motion.take(bodies, slot);
                motion.drag = bodies.drag[slot];
                motion.advance(dt);
                bodies.x[slot] = motion.x;
                bodies.y[slot] = motion.y;
                bodies.velocityX[slot] = motion.velocityX;
                bodies.velocityY[slot] = motion.velocityY;
            }
        }
    }

    private void catchUp(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            if (bodies.isDynamic(roster.awake[i])) {
                course.catchUp(roster.awake[i], dt);
            }
        }
    }
}
