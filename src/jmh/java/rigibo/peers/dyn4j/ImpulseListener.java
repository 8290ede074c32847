package rigibo.peers.dyn4j;

import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.contact.SolvedContact;
import org.dyn4j.world.ContactCollisionData;
import org.dyn4j.world.listener.ContactListenerAdapter;

import rigibo.peers.ImpulseLog;

/**
 * Writes down what contact points did. The contacts that a world has after a step are those of the
 * next one: an impact would be gone from them.
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
