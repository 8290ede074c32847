package rigibo.frontend.scene;

import rigibo.backend.Joint;
import rigibo.backend.MouseJoint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Joints;
import rigibo.backend.setup.BodyType;

import java.util.Optional;

/**
 * A hand that takes hold of a body and pulls it along; a released body flies on. Where joints are
 * declared the hand is a joint, which holds the body where it was grabbed. Elsewhere it sets the
 * body's velocity, so that the body follows with its centre.
 */
public final class Grip {

    /** Share of the way to the pointer that a held body makes up per second. */
    private static final double PULL = 12;

    /** Fastest fling, m/s. */
    private static final double MOST_FLING = 30;

    private RigidBody held;
    private Bench bench;
    private Joint hand;
    private double pointerX;
    private double pointerY;

    /** Takes hold of a dynamic body under a point, world m; returns whether there is one. */
    public boolean grab(Bench from, double x, double y) {
        letGo();
        bench = from;
        Pool pool = from.pool();
        held = under(pool, x, y).orElse(null);
        point(x, y);
        if (held != null && pool.effects().declares(Joints.class)) {
            carrier(pool).ifPresent(any -> hand = from.join(MouseJoint.of(any, held, x, y)));
        }
        return held != null;
    }

    /** What could be taken hold of at a point, world m. */
    public static Optional<RigidBody> under(Pool pool, double x, double y) {
        return pool.bodyAt(x, y).filter(body -> body.type() == BodyType.DYNAMIC);
    }

    /** When a finger at a point, world m, presses: at once what it drags. */
    public static Tap tap(Pool pool, double x, double y) {
        return under(pool, x, y).isPresent() ? Tap.AT_ONCE : Tap.RESTED;
    }

    /** Who carries the joint and feels nothing of it: what stands still, if anything does. */
    private Optional<RigidBody> carrier(Pool pool) {
        Optional<RigidBody> still =
                pool.bodies().stream().filter(body -> body.type() == BodyType.STATIC).findFirst();
        return still.or(() -> pool.bodies().stream().filter(body -> body != held).findFirst());
    }

    /** Lets go of what is held. */
    public void letGo() {
        if (isHand()) {
            bench.part(hand);
        }
        held = null;
        hand = null;
    }

    private boolean isHand() {
        return hand != null && hand.isAlive();
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

    /** Pulls what is held towards the pointer: it keeps its speed when it is let go. */
    public void pull() {
        double x = pointerX;
        double y = pointerY;
        if (isHand()) {
            bench.act(hand, any -> any.target(x, y));
        } else {
            held().ifPresent(body -> bench.act(body, any -> pull(any, x, y)));
        }
    }

    private static void pull(RigidBody body, double x, double y) {
        double vx = PULL * (x - body.x());
        double vy = PULL * (y - body.y());
        double speed = Math.max(1, Math.sqrt(vx * vx + vy * vy) / MOST_FLING);
        body.velocity(vx / speed, vy / speed);
    }
}
