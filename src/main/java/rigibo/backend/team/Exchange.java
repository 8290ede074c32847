package rigibo.backend.team;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;

/**
 * Hands pictures of a state from one thread, the maker, to any number of readers. No thread waits
 * for another, and none has to retry. A reader takes the newest picture by one atomic addition and
 * gives it back by another. The maker overwrites only pictures that nobody reads.
 *
 * <p>One word holds the number of the newest picture and how often that picture was taken. When the
 * maker replaces the word, the count is final. The old picture is free again once it was given back
 * that often. (Split reference counts: A. Williams, C++ Concurrency in Action, 2nd edition 2019,
 * section 7.2.4.) So there are at most two more pictures than readers: the newest, and the one
 * being made.
 *
 * @param <T> a picture, which is reused
 */
public final class Exchange<T> {

    /** Most pictures that may be open at once. */
    public static final int MOST_OPEN = 256;

    /**
     * Bits of the word that hold the count. If one picture were read a billion times a second, they
     * would overflow after three days.
     */
    private static final int COUNT_BITS = 48;

    private static final long COUNT = (1L << COUNT_BITS) - 1;

    /** A picture, and how often it was taken and given back. */
    private static final class Frame<T> {

        final T picture;

        /** How often it was given back since it was published. */
        final AtomicLong returned = new AtomicLong();

        /**
         * How often it was taken; {@link #UNKNOWN} while it is the newest. Only the maker uses it.
         */
        long taken;

        Frame(T picture) {
            this.picture = picture;
        }
    }

    private static final long UNKNOWN = -1;

    private final Supplier<T> blank;

    /** A frame is stored before its number first appears in the word, so that readers see it. */
    private final Frame<T>[] frames;

    private int count;

    /** Number of the frame that the maker is writing, or wrote last. */
    private int drawn;

    /**
     * The word: the newest frame's number in its upper bits, and in the lower how often it was
     * taken.
     */
    private final AtomicLong newest = new AtomicLong();

    private final AtomicInteger open = new AtomicInteger();
    private volatile boolean isClosed;

    /**
     * An exchange without a picture; {@link #publish} must be called before the first {@link
     * #take}.
     *
     * @param blank makes an empty picture, if readers hold all others
     */
    @SuppressWarnings("unchecked")
    public Exchange(Supplier<T> blank) {
        this.blank = blank;
        frames = (Frame<T>[]) new Frame<?>[MOST_OPEN + 2];
    }

    /** For the maker: returns a picture that nobody reads, to be written and then published. */
    public T draw() {
        drawn = free();
        return frames[drawn].picture;
    }

    private int free() {
        for (int i = 0; i < count; i++) {
            if (frames[i].taken == frames[i].returned.get()) {
                return i;
            }
        }
        frames[count] = new Frame<>(blank.get());
        return count++;
    }

    /** For the maker: makes the picture it has written the newest. */
    public void publish() {
        Frame<T> drawing = frames[drawn];
        assert drawing.taken != UNKNOWN : "a picture that is already read";
        drawing.returned.set(0);
        drawing.taken = UNKNOWN;
        long before = newest.getAndSet((long) drawn << COUNT_BITS);
        Frame<T> old = frames[(int) (before >>> COUNT_BITS)];
        if (old != drawing) {
            old.taken = before & COUNT;
        }
    }

    /**
     * Takes the newest picture, on any thread.
     *
     * @throws IllegalStateException when {@link #MOST_OPEN} are open, or the exchange was closed
     */
    public Lease<T> take() {
        if (isClosed) {
            throw new IllegalStateException(
                    "no more pictures are made: the pool was closed; ask it to share again");
        }
        if (open.incrementAndGet() > MOST_OPEN) {
            open.decrementAndGet();
            throw new IllegalStateException(
                    "at most "
                            + MOST_OPEN
                            + " pictures may be open at once; close each after reading it");
        }
        return new Lease<>(this, (int) (newest.getAndIncrement() >>> COUNT_BITS));
    }

    T picture(int frame) {
        return frames[frame].picture;
    }

    void giveBack(int frame) {
        frames[frame].returned.incrementAndGet();
        open.decrementAndGet();
    }

    /** Number of pictures that were ever made. */
    public int pictures() {
        return count;
    }

    /** Refuses further readings. Pictures that are open stay as they are until they are closed. */
    public void close() {
        isClosed = true;
    }

    /** Whether readings are refused. */
    public boolean isClosed() {
        return isClosed;
    }
}
