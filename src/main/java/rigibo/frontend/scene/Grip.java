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

    /** The body that could be taken hold of at a point, world m. */
    public static Optional<RigidBody> under(Pool pool, double x, double y) {
        return pool.bodyAt(x, y).filter(body -> body.type() == BodyType.DYNAMIC);
    }

    /** When a finger at a point, world m, presses: at once if there is something to drag. */
    public static Tap tap(Pool pool, double x, double y) {
        return under(pool, x, y).isPresent() ? Tap.AT_ONCE : Tap.RESTED;
    }

    /**
     * The body that the mouse joint is attached to, without effect on it: one that stands still, if
     * there is any.
     */
    private Optional<RigidBody> carrier(Pool pool) {
        Optional<RigidBody> still =
                pool.bodies().stream().filter(body -> body.type() == BodyType.STATIC).findFirst();
        return still.or(() -> pool.bodies().stream().filter(body -> body != held).findFirst());
    }

    /** Lets go of the held body. */
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

    /** The held body, if it is still in the pool. */
    public Optional<RigidBody> held() {
        return Optional.ofNullable(held).filter(RigidBody::isAlive);
    }

    /** Pulls the held body towards the pointer; when it is let go, it keeps its speed. */
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
