package rigibo.backend;

import rigibo.backend.storage.Pairs;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Shows visitors the contacts of a state's last step: those in the pairs, and those that edits took
 * from the pairs.
 */
final class ContactVisits {

    private final Pairs pairs;
    private final ContactReader reader;
    private final ContactView view = new ContactView();
    private final Busy busy;

    ContactVisits(Queried state, Busy busy) {
        this.busy = busy;
        pairs = state.pairs();
        reader = new ContactReader(state);
    }

    /** All contacts as a new list; the ones in the pairs are the first. */
    List<ContactEvent> list(List<ContactEvent> cut, List<ContactEvent> ended) {
        List<ContactEvent> events = new ArrayList<>();
        forEach(cut, ended, contact -> events.add(contact.event()));
        return events;
    }

    /**
     * Visits every contact; a visit nested in another one uses a view of its own.
     *
     * @param cut contacts of the last step that edits have ended since
     * @param ended contacts of which the last step reported the end, since edits had ended them
     */
    void forEach(
            List<ContactEvent> cut,
            List<ContactEvent> ended,
            Consumer<? super ContactView> visitor) {
        ContactView shown = busy.isVisited() ? new ContactView() : view;
        busy.beginVisit();
        try {
            forEachPair(shown, visitor);
            forEach(cut, shown, visitor);
            forEach(ended, shown, visitor);
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

    private static void forEach(
            List<ContactEvent> events, ContactView shown, Consumer<? super ContactView> visitor) {
        for (int i = 0; i < events.size(); i++) {
            shown.show(events.get(i));
            visitor.accept(shown);
        }
    }
}
