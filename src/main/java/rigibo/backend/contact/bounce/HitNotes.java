package rigibo.backend.contact.bounce;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.impact.Impact;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Hits;
import rigibo.backend.storage.Pairs;

/** Records the impacts within an island as hits, except those that flight has recorded before. */
public final class HitNotes {

    private final Bodies bodies;
    private final Pairs pairs;
    private final Hits hits;
    private final Motions motions;
    private final PackedContacts contacts;

    /** Start of the present part of a substep, s after the step's start. */
    public double start;

    public HitNotes(DataStorage data, Motions motions, PackedContacts contacts) {
        bodies = data.bodies;
        pairs = data.pairs;
        hits = data.noteHits();
        this.motions = motions;
        this.contacts = contacts;
    }

    /**
     * Records the impact of a row whose points are loaded, with their closing speed in m/s, {@code
     * ahead} seconds after the start of the present part.
     */
    public void note(int row, Impact impact, double closing, double ahead) {
        int pair = contacts.pair[row];
        if (impact.points == 0 || hits.wasForetold(pair)) {
            return;
        }
        boolean isOnA = contacts.bodyA[row] != 0;
        int at = isOnA ? contacts.bodyA[row] : contacts.bodyB[row];
        double[] armX = isOnA ? impact.armAX : impact.armBX;
        double[] armY = isOnA ? impact.armAY : impact.armBY;
        int last = impact.points - 1;
        hits.add(
                bodies,
                pairs,
                pair,
                motions.x(bodies, at, ahead, start + ahead) + (armX[0] + armX[last]) / 2,
                motions.y(bodies, at, ahead, start + ahead) + (armY[0] + armY[last]) / 2,
                closing,
                start + ahead);
    }
}
