package rigibo.backend;

import rigibo.backend.ContactEvent.Phase;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

/** Reads the contacts of a state's last step from the columns of pairs. */
final class ContactReader {

    private final Queried state;
    private final Bodies bodies;
    private final Pairs pairs;

    ContactReader(Queried state) {
        this.state = state;
        bodies = state.bodies();
        pairs = state.pairs();
    }

    /** Writes a pair into a view; returns false for a pair without a contact to report. */
    boolean read(int pair, ContactView into) {
        boolean touched = pairs.touched(pair);
        boolean before = pairs.touchedBefore[pair];
        if (!touched && !before) {
            return false;
        }
        int last = 2 * pair + Math.max(pairs.points[pair], 1) - 1;
        into.a = state.handle(pairs.bodyA[pair]);
        into.b = state.handle(pairs.bodyB[pair]);
        into.partA = bodies.partOf(pairs.shapeA(pair));
        into.partB = bodies.partOf(pairs.shapeB(pair));
        into.phase = !touched ? Phase.END : before ? Phase.PERSIST : Phase.BEGIN;
        into.x = (pairs.pointX[2 * pair] + pairs.pointX[last]) / 2;
        into.y = (pairs.pointY[2 * pair] + pairs.pointY[last]) / 2;
        into.normalX = pairs.normalX[pair];
        into.normalY = pairs.normalY[pair];
        into.impulse = pairs.impulse[pair];
        into.isCrushing = pairs.crushed[pair];
        into.friction = pairs.heldFriction(pair);
        into.points = pairs.points[pair];
        for (int i = 0; i < into.points; i++) {
            into.pointX[i] = pairs.pointX[2 * pair + i];
            into.pointY[i] = pairs.pointY[2 * pair + i];
            into.separation[i] = pairs.separation[2 * pair + i];
            into.force[i] = pairs.normalForce[2 * pair + i];
        }
        return true;
    }
}
