package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Quarantine;

/** Writes the result of a packed island back into the storage. */
public final class IslandResults {

    /** Time over which a contact's load is averaged, s: longer than a pile rocks. */
    private static final double LOAD_MEMORY = 2;

    private final Quarantine quarantine;
    private final Bodies bodies;
    private final Pairs pairs;
    private final Islands islands;
    private final Motions motions;
    private final PackedContacts contacts;

    /** Turning of the packed bodies; null without rotation. */
    private final PackedTurns turns;

    public IslandResults(
            DataStorage data, Motions motions, PackedContacts contacts, PackedTurns turns) {
        this.turns = turns;
        quarantine = new Quarantine(data);
        bodies = data.bodies;
        pairs = data.pairs;
        islands = data.islands;
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Stores an island that was advanced by {@code length} s in substeps of {@code h} s. */
    public void store(double h, double length) {
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            if (bodies.isDynamic(slot)) {
                storeBody(slot, entry * Motions.STRIDE);
            }
        }
        if (turns != null) {
            turns.store();
        }
        for (int row = 0; row < contacts.count; row++) {
            storePair(row, h, Math.min(1, length / LOAD_MEMORY));
        }
    }

    /** Puts bodies of the packed island to rest whose state is not within bounds. */
    public void quarantine() {
        for (int entry = 1; entry < motions.count; entry++) {
            quarantine.putToRestIfUnbounded(motions.slots[entry]);
        }
    }

    /** Keeps an island in place for a step of {@code dt} seconds, with the forces it carries. */
    public void goOn(int island, double dt) {
        for (int i = islands.pairStart[island]; i < islands.pairStart[island + 1]; i++) {
            int pair = islands.pairs[i];
            double force = pairs.normalForce[2 * pair] + pairs.normalForce[2 * pair + 1];
            remember(2 * pair, Math.min(1, dt / LOAD_MEMORY));
            remember(2 * pair + 1, Math.min(1, dt / LOAD_MEMORY));
            pairs.tellImpulse(pair, dt * force);
            noteTouch(pair, force);
            contacts.work.crushed += pairs.crushed[pair] ? 1 : 0;
        }
    }

    private void storeBody(int slot, int at) {
        double[] m = motions.data;
        bodies.x[slot] += m[at + Motions.DX];
        bodies.y[slot] += m[at + Motions.DY];
        bodies.velocityX[slot] = m[at + Motions.VX];
        bodies.velocityY[slot] = m[at + Motions.VY];
    }

    /** Stores a contact's forces: the impulses of the last half kick divided by its length. */
    private void storePair(int row, double h, double share) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        int pair = contacts.pair[row];
        pairs.crushed[pair] |= isCrushed(row);
        contacts.work.crushed += pairs.crushed[pair] ? 1 : 0;
        if (!isFinite(at)) {
            forgetForces(pair);
            return;
        }
        double perSecond = 2 / h;
        int first = isOfSecond(row, pair) ? 1 : 0;
        pairs.normalForce[2 * pair + first] = d[at + PackedContacts.IMPULSE0] * perSecond;
        pairs.normalForce[2 * pair + 1 - first] = d[at + PackedContacts.IMPULSE1] * perSecond;
        remember(2 * pair, share);
        remember(2 * pair + 1, share);
        double carried = d[at + PackedContacts.IMPULSE0] + d[at + PackedContacts.IMPULSE1];
        pairs.tellImpulse(pair, d[at + PackedContacts.TOTAL]);
        noteTouch(pair, carried);
        if (d[at + PackedContacts.TOTAL] > 0 && !(carried > 0)) {
            // They pushed each other and parted again, which is an impact for those who listen.
            pairs.impacts[pair]++;
        }
    }

    /** Whether a row that stands for two points is that of the second one, the deeper of them. */
    private boolean isOfSecond(int row, int pair) {
        return contacts.points[row] < pairs.points[pair]
                && pairs.separation[2 * pair + 1] < pairs.separation[2 * pair];
    }

    /** Whether a contact is crushed at the end of the step. */
    private boolean isCrushed(int row) {
        int pair = contacts.pair[row];
        return RowBuilder.isCrushed(bodies, pairs, pair, motions.gap(contacts, row));
    }

    private boolean isFinite(int at) {
        double[] d = contacts.data;
        double sum =
                d[at + PackedContacts.IMPULSE0]
                        + d[at + PackedContacts.IMPULSE1]
                        + d[at + PackedContacts.TOTAL];
        return Math.abs(sum) < Double.POSITIVE_INFINITY;
    }

    /** Drops non-finite forces, which would spoil every later step. */
    private void forgetForces(int pair) {
        for (int point = 2 * pair; point < 2 * pair + 2; point++) {
            pairs.normalForce[point] = 0;
            pairs.load[point] = 0;
        }
    }

    private void noteTouch(int pair, double carried) {
        if (carried > 0) {
            pairs.resting[pair] = true;
            pairs.touching[pair] = true;
        }
    }

    /** Moves a point's averaged load by a share towards its present force. */
    private void remember(int point, double share) {
        pairs.load[point] += share * (pairs.normalForce[point] - pairs.load[point]);
    }
}
