package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

/**
 * Contacts with running surfaces, such as conveyors: friction aims at their speed. Both outlines
 * run counter-clockwise, so that their speeds add at a contact.
 */
public final class RunningRows {

    private final Bodies bodies;
    private final Pairs pairs;
    private final PackedContacts contacts;

    public RunningRows(DataStorage data, PackedContacts contacts) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.contacts = contacts;
    }

    /** Writes the surface speeds of the packed contacts. */
    public void begin() {
        for (int row = 0; row < contacts.count; row++) {
            int pair = contacts.pair[row];
            contacts.running[row] = pairs.surfaceSpeed(bodies, pair);
            contacts.surface[row] = contacts.running[row];
            contacts.isAnyRunning |= contacts.running[row] != 0;
        }
    }
}
