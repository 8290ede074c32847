package rigibo.peers.gdx;

import com.badlogic.gdx.physics.box2d.Contact;
import com.badlogic.gdx.physics.box2d.ContactImpulse;
import com.badlogic.gdx.physics.box2d.ContactListener;
import com.badlogic.gdx.physics.box2d.Manifold;

import rigibo.peers.ImpulseLog;

/** Records the impulses of contacts, those of continuous collision included. */
final class ImpulseListener implements ContactListener {

    private final ImpulseLog log;

    ImpulseListener(ImpulseLog log) {
        this.log = log;
    }

    @Override
    public void postSolve(Contact contact, ContactImpulse impulse) {
        float[] normal = impulse.getNormalImpulses();
        double sum = 0;
        for (int i = 0; i < impulse.getCount(); i++) {
            sum += normal[i];
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
