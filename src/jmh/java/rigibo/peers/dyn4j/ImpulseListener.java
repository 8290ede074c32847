package rigibo.peers.dyn4j;

import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.contact.SolvedContact;
import org.dyn4j.world.ContactCollisionData;
import org.dyn4j.world.listener.ContactListenerAdapter;

import rigibo.peers.ImpulseLog;

/**
 * Records the impulses of contact points. After a step a world holds the contacts of the next one,
 * in which an impact no longer appears.
 */
final class ImpulseListener extends ContactListenerAdapter<Body> {

    private final ImpulseLog log;

    ImpulseListener(ImpulseLog log) {
        this.log = log;
    }

    @Override
    public void postSolve(ContactCollisionData<Body> pair, SolvedContact point) {
        log.add(
                (Integer) pair.getBody1().getUserData(),
                (Integer) pair.getBody2().getUserData(),
                point.getNormalImpulse());
    }
}
