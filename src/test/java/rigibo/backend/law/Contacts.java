package rigibo.backend.law;

import rigibo.backend.ContactEvent;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.ImpactMode;

import java.util.function.Predicate;

/** The contacts of a pool's last step. */
final class Contacts {

    private Contacts() {}

    /** Contacts that began: bodies that met, bounces within the step included. */
    static long begun(Pool pool) {
        return count(pool, event -> event.phase() == ContactEvent.Phase.BEGIN);
    }

    /** Contacts in which something was pressed. */
    static long loaded(Pool pool) {
        return count(pool, event -> event.impulse() > 0);
    }

    /** Contacts between two bodies that both can move, in which something was pressed. */
    static long loadedInPiles(Pool pool) {
        return count(pool, event -> event.impulse() > 0 && isFree(event.a()) && isFree(event.b()));
    }

    /**
     * Whether bodies stay in touch: a pile had to be solved. Where impacts are not looked for in
     * flight, as at DRAFT, piles see to them too, and only what persists tells.
     */
    static boolean last(Pool pool) {
        return pool.accuracy().impacts() == ImpactMode.EVENTS
                ? pool.report().rows() > 0
                : count(pool, event -> event.phase() == ContactEvent.Phase.PERSIST) > 0;
    }

    private static boolean isFree(RigidBody body) {
        return body.isAlive() && body.type() == BodyType.DYNAMIC;
    }

    private static long count(Pool pool, Predicate<ContactEvent> wanted) {
        return pool.contactEvents().stream().filter(wanted).count();
    }
}
