package rigibo.backend;

import rigibo.backend.ContactEvent.Phase;
import rigibo.backend.saved.SavedContact;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairIndex;
import rigibo.backend.storage.Pairs;

import java.util.ArrayList;
import java.util.List;

/**
 * Contacts that an edit between two steps takes from the pairs, because a body was removed or
 * moved. Until the next step they are still reported as the last step left them. The next step
 * reports the end of each, unless the bodies touch again.
 */
final class EndedContacts {

    private static final Phase[] PHASES = Phase.values();

    private final Pool pool;
    private final Bodies bodies;
    private final Pairs pairs;
    private final ContactReader reader;
    private final ContactView view = new ContactView();

    /** Contacts of the last step that edits have ended since. */
    private final List<ContactEvent> cut = new ArrayList<>();

    /** The END events that the next step reports, unless the bodies touch again. */
    private final List<ContactEvent> ending = new ArrayList<>();

    /** The END events of the last step for contacts that edits ended before it. */
    private final List<ContactEvent> ended = new ArrayList<>();

    EndedContacts(Pool pool, DataStorage data, ContactReader reader) {
        this.pool = pool;
        bodies = data.bodies;
        pairs = data.pairs;
        this.reader = reader;
    }

    /** Records the contacts of a body whose pairs are about to be removed. */
    void cutAllOf(int slot) {
        for (int p = bodies.firstPairOf(slot); p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            cut(p);
        }
    }

    /** Records every contact, since all pairs are about to be removed. */
    void cutAll() {
        for (int pair = 0; pair < pairs.slots.high; pair++) {
            if (pairs.bodyA[pair] != Pairs.NONE) {
                cut(pair);
            }
        }
    }

    /** Records the contact of a pair that is about to be removed. */
    void cut(int pair) {
        if (reader.read(pair, view)) {
            cut(view.event());
        }
    }

    private void cut(ContactEvent event) {
        cut.add(event);
        if (event.phase() != Phase.END) {
            view.show(event);
            view.phase = Phase.END;
            view.impulse = 0;
            view.isCrushing = false;
            ending.add(view.event());
        }
    }

    /** Tells after a step what became of the contacts that were cut before it. */
    void follow() {
        cut.clear();
        ended.clear();
        for (int i = 0; i < ending.size(); i++) {
            if (!goesOn(ending.get(i))) {
                ended.add(ending.get(i));
            }
        }
        ending.clear();
    }

    /** Whether the bodies touched in the step too; if so, marks their pair as persisting. */
    private boolean goesOn(ContactEvent event) {
        if (!event.bothAlive()) {
            return false;
        }
        int shapeA = bodies.shapeOf(event.a().slot(), event.partA());
        int shapeB = bodies.shapeOf(event.b().slot(), event.partB());
        if (shapeA == Pairs.NONE || shapeB == Pairs.NONE) {
            return false;
        }
        // Slots of bodies do not change, so the lower one is still that of A.
        int pair = pairs.index.find(shapeA, shapeB);
        if (pair == PairIndex.ABSENT || !pairs.touched(pair)) {
            return false;
        }
        pairs.touchedBefore[pair] = true;
        return true;
    }

    /** Contacts of the last step that edits have ended since, as the step left them. */
    List<ContactEvent> cut() {
        return cut;
    }

    /** What the last step reported of contacts that edits ended before it. */
    List<ContactEvent> ended() {
        return ended;
    }

    /**
     * The contacts to be saved; those of removed bodies are not, since a restored pool has no
     * handle.
     */
    List<SavedContact> saved() {
        List<SavedContact> saved = new ArrayList<>();
        cut.stream().filter(ContactEvent::bothAlive).map(e -> saved(e, true)).forEach(saved::add);
        ended.stream()
                .filter(ContactEvent::bothAlive)
                .map(e -> saved(e, false))
                .forEach(saved::add);
        return saved;
    }

    private static SavedContact saved(ContactEvent event, boolean isCut) {
        return new SavedContact(
                event.a().slot(),
                event.b().slot(),
                event.partA(),
                event.partB(),
                isCut,
                event.phase().ordinal(),
                event.x(),
                event.y(),
                event.normalX(),
                event.normalY(),
                event.impulse(),
                event.isCrushing());
    }

    /** Restores a saved contact. */
    void restore(SavedContact contact) {
        ContactEvent event =
                new ContactEvent(
                        pool.handle(contact.a()),
                        pool.handle(contact.b()),
                        contact.partA(),
                        contact.partB(),
                        PHASES[contact.phase()],
                        contact.x(),
                        contact.y(),
                        contact.normalX(),
                        contact.normalY(),
                        contact.impulse(),
                        contact.isCrushing());
        if (contact.isCut()) {
            cut(event);
        } else {
            ended.add(event);
        }
    }
}
