package rigibo.backend;

import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Reports the contacts of the last step: those in the pairs, and those that edits ended since. */
final class PoolContacts {

    final EndedContacts ended;
    private final Pairs pairs;
    private final ContactReader reader;
    private final ContactView view = new ContactView();
    private final Busy busy;

    PoolContacts(Pool pool, DataStorage data, Busy busy) {
        this.busy = busy;
        pairs = data.pairs;
        reader = new ContactReader(pool, data);
        ended = new EndedContacts(pool, data, reader);
    }

    List<ContactEvent> list() {
        List<ContactEvent> events = new ArrayList<>();
        forEach(contact -> events.add(contact.event()));
        return events;
    }

    /** Visits every contact; a visit nested in another one uses a view of its own. */
    void forEach(Consumer<? super ContactView> visitor) {
        ContactView shown = busy.isVisited() ? new ContactView() : view;
        busy.beginVisit();
        try {
            forEachPair(shown, visitor);
            ended.forEach(shown, visitor);
        } finally {
            busy.endVisit();
        }
    }

    private void forEachPair(ContactView shown, Consumer<? super ContactView> visitor) {
        for (int pair = 0; pair < pairs.slots.high; pair++) {
            if (pairs.bodyA[pair] != Pairs.NONE && reader.read(pair, shown)) {
                visitor.accept(shown);
            }
        }
    }
}
