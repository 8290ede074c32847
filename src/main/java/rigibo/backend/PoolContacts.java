package rigibo.backend;

import rigibo.backend.storage.DataStorage;

import java.util.List;
import java.util.function.Consumer;

/** Reports the contacts of the last step: those in the pairs, and those that edits ended since. */
final class PoolContacts {

    final EndedContacts ended;
    private final ContactVisits visits;

    PoolContacts(Pool pool, DataStorage data, LiveState live, Busy busy) {
        visits = new ContactVisits(live, busy);
        ended = new EndedContacts(pool, data, new ContactReader(live));
    }

    List<ContactEvent> list() {
        return visits.list(ended.cut(), ended.ended());
    }

    void forEach(Consumer<? super ContactView> visitor) {
        visits.forEach(ended.cut(), ended.ended(), visitor);
    }
}
