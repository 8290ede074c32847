package rigibo.frontend.scene;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;

import java.util.Optional;

/** A hand that takes hold of a body of a pool and pulls it along: let go, it flies on. */
public final class Grip {

    /** Share of the way to the pointer that a held body makes up per second. */
    private static final double PULL = 12;

    /** Fastest fling, m/s. */
    private static final double MOST_FLING = 30;

    private RigidBody held;
    private double pointerX;
    private double pointerY;

    /** Takes hold of a dynamic body under a point, world m; returns whether there is one. */
    public boolean grab(Pool pool, double x, double y) {
        held = pool.bodyAt(x, y).filter(body -> body.type() == BodyType.DYNAMIC).orElse(null);
        point(x, y);
        return held != null;
    }

    /** Lets go of what is held. */
    public void letGo() {
        held = null;
    }

    /** Where the pointer is, world m. */
    public void point(double x, double y) {
        pointerX = x;
        pointerY = y;
    }

    /** World m. */
    public double pointerX() {
        return pointerX;
    }

    /** World m. */
    public double pointerY() {
        return pointerY;
    }

    /** What is held, if it is still there. */
    public Optional<RigidBody> held() {
        return Optional.ofNullable(held).filter(RigidBody::isAlive);
    }

    /** Pulls a body towards the pointer: it keeps its speed when it is let go. */
    public void pull(RigidBody body) {
        double vx = PULL * (pointerX - body.x());
        double vy = PULL * (pointerY - body.y());
        double speed = Math.max(1, Math.sqrt(vx * vx + vy * vy) / MOST_FLING);
        body.velocity(vx / speed, vy / speed);
    }
}
