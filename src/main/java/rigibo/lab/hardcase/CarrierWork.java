package rigibo.lab.hardcase;

import rigibo.backend.ContactEvent;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;

/**
 * The work of driven bodies that all move to the right at one speed u while weight pulls straight
 * down: u times the momentum they hand over, which is all that the bodies have got beyond what
 * fixed bodies gave them. What fixed bodies give is taken from their contacts' normal impulses: a
 * vertical wall rubs straight up and down.
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

    /** Of the last step, J; to be asked after each. */
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
