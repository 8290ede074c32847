package rigibo.backend;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.ConcurrentModificationException;
import java.util.Iterator;
import java.util.ListIterator;
import java.util.NoSuchElementException;
import java.util.Objects;
import java.util.RandomAccess;
import java.util.Spliterator;
import java.util.Spliterators;

/**
 * The bodies of a pool in the order they were added. A removed body leaves a gap, so that the cost
 * of a removal does not grow with the number of bodies; the gaps are closed when an index beyond
 * the first of them is read.
 *
 * <p>Only the pool changes the list; as a {@link java.util.List} it is read-only.
 */
final class BodyList extends AbstractList<RigidBody> implements RandomAccess {

    private RigidBody[] places = new RigidBody[16];
    private RigidBody[] bySlot = new RigidBody[16];

    /** End of the used range of {@code places}; the range has no gap before {@code firstGap}. */
    private int high;

    private int firstGap;
    private int size;

    /** How often closing gaps moved a body: tests bound the cost of removals by it. */
    private long moves;

    /** Adds a body at the end and returns it. */
    RigidBody append(RigidBody body) {
        if (high == places.length) {
            closeGaps();
            makeRoom();
        }
        if (body.slot() >= bySlot.length) {
            bySlot = Arrays.copyOf(bySlot, 2 * body.slot());
        }
        bySlot[body.slot()] = body;
        firstGap += firstGap == high ? 1 : 0;
        put(body, high++);
        size++;
        modCount++;
        return body;
    }

    /** Removes a body that is in the list. */
    void drop(RigidBody body) {
        bySlot[body.slot()] = null;
        places[body.place] = null;
        firstGap = Math.min(firstGap, body.place);
        size--;
        modCount++;
    }

    /** The body of a slot that is in use. */
    RigidBody atSlot(int slot) {
        return bySlot[slot];
    }

    long moves() {
        return moves;
    }

    /** Number of bodies for which there is room. */
    int room() {
        return places.length;
    }

    /** One more than the highest slot for which there is room. */
    int slots() {
        return bySlot.length;
    }

    /** A number that differs from all former ones after a body was added or removed. */
    int edition() {
        return modCount;
    }

    @Override
    public int size() {
        return size;
    }

    @Override
    public RigidBody get(int index) {
        Objects.checkIndex(index, size);
        if (index >= firstGap) {
            closeGaps();
        }
        return places[index];
    }

    @Override
    public Iterator<RigidBody> iterator() {
        return listIterator(0);
    }

    @Override
    public ListIterator<RigidBody> listIterator(int index) {
        Objects.checkIndex(index, size + 1);
        closeGaps();
        return new Walk(index);
    }

    /**
     * Built on the iterator, which reports a change at once; the default spliterator of lists
     * reports it only at the end.
     */
    @Override
    public Spliterator<RigidBody> spliterator() {
        return Spliterators.spliterator(this, Spliterator.ORDERED | Spliterator.NONNULL);
    }

    /** Doubles the array, unless closing the gaps freed at least half of it. */
    private void makeRoom() {
        if (high > places.length / 2) {
            places = Arrays.copyOf(places, 2 * places.length);
        }
    }

    private void closeGaps() {
        int to = firstGap;
        for (int from = firstGap; from < high; from++) {
            if (places[from] != null) {
                put(places[from], to++);
                moves++;
            }
        }
        Arrays.fill(places, to, high, null);
        high = to;
        firstGap = to;
    }

    private void put(RigidBody body, int place) {
        places[place] = body;
        body.place = place;
    }

    /**
     * After a change of the list {@link #hasNext} is always true, so that {@link #next} throws;
     * comparing the index with the new size could end a loop silently one body too early.
     */
    private final class Walk implements ListIterator<RigidBody> {

        private final int expected = modCount;
        private int at;

        private Walk(int at) {
            this.at = at;
        }

        @Override
        public boolean hasNext() {
            return at < size || modCount != expected;
        }

        @Override
        public boolean hasPrevious() {
            return at > 0 || modCount != expected;
        }

        @Override
        public RigidBody next() {
            requireUnchanged();
            if (at == size) {
                throw new NoSuchElementException();
            }
            return places[at++];
        }

        @Override
        public RigidBody previous() {
            requireUnchanged();
            if (at == 0) {
                throw new NoSuchElementException();
            }
            return places[--at];
        }

        @Override
        public int nextIndex() {
            return at;
        }

        @Override
        public int previousIndex() {
            return at - 1;
        }

        @Override
        public void remove() {
            throw new UnsupportedOperationException("bodies are removed by Pool.remove");
        }

        @Override
        public void set(RigidBody body) {
            throw new UnsupportedOperationException("bodies keep their order");
        }

        @Override
        public void add(RigidBody body) {
            throw new UnsupportedOperationException("bodies are added by Pool.add");
        }

        private void requireUnchanged() {
            if (modCount != expected) {
                throw new ConcurrentModificationException(
                        "a body was added or removed while Pool.bodies() was gone through; go"
                                + " through List.copyOf(pool.bodies()) instead");
            }
        }
    }
}
