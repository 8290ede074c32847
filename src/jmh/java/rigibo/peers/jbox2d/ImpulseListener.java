package rigibo.peers.jbox2d;

import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.dynamics.contacts.Contact;

import rigibo.peers.ImpulseLog;

/** Records the impulses of contacts, those of continuous collision included. */
final class ImpulseListener implements ContactListener {

    private final ImpulseLog log;

    ImpulseListener(ImpulseLog log) {
        this.log = log;
    }

    @Override
    public void postSolve(Contact contact, ContactImpulse impulse) {
        double sum = 0;
        for (int i = 0; i < impulse.count; i++) {
            sum += impulse.normalImpulses[i];
        }
        log.add(
                (Integer) contact.getFixtureA().getBody().getUserData(),
                (Integer) contact.getFixtureB().getBody().getUserData(),
                sum);
    }

    @Override
    public void beginContact(Contact contact) {}

    @Override
    public void endContact(Contact contact) {}

    @Override
    public void preSolve(Contact contact, Manifold before) {}
}
