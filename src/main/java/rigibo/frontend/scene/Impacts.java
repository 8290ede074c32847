package rigibo.frontend.scene;

import rigibo.backend.ContactEvent;
import rigibo.backend.ContactView;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;

import java.util.function.Function;

/**
 * Plays sounds for the contacts of a pool, step by step, except in the first step, in which every
 * body begins to touch its support under the weight of all bodies above it.
 */
public final class Impacts {

    /**
     * Smallest change of velocity that is heard, m/s. A body at rest gets g·dt = 0.16 m/s from its
     * support in every step, and its last bounces are no faster than that. Twice as much is a
     * knock.
     */
    private static final double HEARD = 0.35;

    private boolean hasBegun;

    /**
     * Tells the impacts among the contacts of a pool's last step.
     *
     * @param skins of the bodies that move
     */
    public void tell(Pool pool, Function<RigidBody, Skin> skins, Sounds sounds) {
        if (hasBegun) {
            pool.forEachContact(contact -> tell(contact, skins, sounds));
        }
        hasBegun = true;
    }

    private static void tell(ContactView contact, Function<RigidBody, Skin> skins, Sounds sounds) {
        if (contact.phase == ContactEvent.Phase.BEGIN && contact.bothAlive()) {
            RigidBody lighter = lighter(contact);
            if (contact.impulse > HEARD * lighter.mass()) {
                double size = Math.sqrt(lighter.shape().area());
                sounds.knock(skins.apply(lighter), size, contact.impulse);
            }
        }
    }

    /** The body that the impact moves more, which is never the ground. */
    private static RigidBody lighter(ContactView contact) {
        return contact.a.mass() < contact.b.mass() ? contact.a : contact.b;
    }
}
