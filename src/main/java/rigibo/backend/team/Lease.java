package rigibo.backend.team;

/**
 * One thread's right to read a picture: nobody writes the picture until the lease is closed.
 *
 * @param <T> the picture
 */
public final class Lease<T> implements AutoCloseable {

    private final Exchange<T> exchange;
    private final int frame;
    private final Thread reader = Thread.currentThread();

    /** Used by the reader alone; other threads are refused before they get here. */
    private boolean isClosed;

    Lease(Exchange<T> exchange, int frame) {
        this.exchange = exchange;
        this.frame = frame;
    }

    /**
     * The picture.
     *
     * @throws IllegalStateException when it was closed, or by another thread than the one that took
     *     it
     */
    public T picture() {
        requireReadable();
        return exchange.picture(frame);
    }

    /**
     * Gives the picture back.
     *
     * @throws IllegalStateException as {@link #picture} does
     */
    @Override
    public void close() {
        requireReadable();
        isClosed = true;
        exchange.giveBack(frame);
    }

    private void requireReadable() {
        Thread current = Thread.currentThread();
        if (current != reader) {
            throw new IllegalStateException(
                    "a picture is for the thread that took it, '"
                            + reader.getName()
                            + "', not for '"
                            + current.getName()
                            + "': each thread takes its own");
        }
        if (isClosed) {
            throw new IllegalStateException("the picture was closed; take another one");
        }
    }
}
