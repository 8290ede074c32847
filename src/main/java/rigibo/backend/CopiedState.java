package rigibo.backend;

import rigibo.backend.broadphase.CopiedFixtures;
import rigibo.backend.storage.QueriedColumns;

import java.util.ArrayList;
import java.util.List;

/** A copy of what queries read of a pool. While it is read, nobody writes it. */
final class CopiedState {

    final QueriedColumns columns = new QueriedColumns();
    final CopiedFixtures fixtures = new CopiedFixtures();
    final Roll roll = new Roll();

    /** See {@link EndedContacts}. */
    final List<ContactEvent> cut = new ArrayList<>();

    final List<ContactEvent> ended = new ArrayList<>();

    /** Whether contacts are declared, so that there are fixtures. */
    boolean hasFixtures;

    /** Steps finished since the pool was asked to share, and the time, s since it was made. */
    long step;

    double time;

    /**
     * Copies a pool's state.
     *
     * @param edited the contacts that edits ended; null if contacts were never read
     */
    void copy(LiveState live, BodyList bodies, EndedContacts edited) {
        columns.copy(live.data());
        roll.copy(bodies);
        hasFixtures = live.broadphase() != null;
        if (hasFixtures) {
            fixtures.copy(live.broadphase());
        }
        cut.clear();
        ended.clear();
        if (edited != null) {
            copy(edited.cut(), cut);
            copy(edited.ended(), ended);
        }
    }

    /** One by one: {@code addAll} makes an array. */
    private static void copy(List<ContactEvent> from, List<ContactEvent> to) {
        for (int i = 0; i < from.size(); i++) {
            to.add(from.get(i));
        }
    }
}
