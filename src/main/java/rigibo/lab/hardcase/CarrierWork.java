package rigibo.lab.hardcase;

import rigibo.backend.ContactEvent;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;

/**
 * The work of driven bodies that all move to the right at one speed u under vertical gravity. It is
 * u times the momentum that they transfer: the momentum of all bodies minus the part that comes
 * from fixed bodies. That part is the sum of their normal impulses, since the friction of a
 * vertical wall is vertical.
 */
final class CarrierWork {

    private final WatchedPool pool;
    private final RigidBody carrier;
    private double momentum;

    CarrierWork(WatchedPool pool, RigidBody carrier) {
        this.pool = pool;
        this.carrier = carrier;
        momentum = momentum();
    }

    /** The work of the last step, J; called after each step. */
    double ofStep() {
        double before = momentum;
        momentum = momentum();
        return carrier.velocityX() * (momentum - before - fromFixed());
    }

    private double momentum() {
        double sum = 0;
        for (RigidBody body : pool.pool().bodies()) {
            boolean isMoved = body.type() == BodyType.DYNAMIC;
            sum += isMoved ? body.mass() * body.velocityX() : 0;
        }
        return sum;
    }

    private double fromFixed() {
        double sum = 0;
        for (ContactEvent event : pool.pool().contactEvents()) {
            double towardsB = event.impulse() * event.normalX();
            sum += event.a().type() == BodyType.STATIC ? towardsB : 0;
            sum -= event.b().type() == BodyType.STATIC ? towardsB : 0;
        }
        return sum;
    }
}
