package rigibo.backend;

import rigibo.backend.team.Exchange;

/**
 * Lets any thread query a pool while it steps. Each finished step makes a picture of the pool, and
 * a reader takes the newest one; neither waits for the other. An edit between steps shows in the
 * picture of the next step, or at once after {@link #publish}.
 *
 * <pre>{@code
 * SharedView view = pool.shared(); // on the thread that steps
 * // On any thread, at any time:
 * try (Picture picture = view.read()) {
 *     picture.bodyAt(2, 1).ifPresent(body -> System.out.println(picture.y(body)));
 * }
 * }</pre>
 *
 * <p>A step copies what queries read, about 180 bytes a body and 120 a pair. It never waits for
 * readers and, once warm, allocates nothing. The pool keeps two copies more than pictures were ever
 * open at once. Pictures tell poses, shapes and contacts; only the pool tells joints, hits and what
 * sensors saw.
 */
public final class SharedView {

    /** Most pictures that may be open at once, all threads counted. */
    public static final int MOST_OPEN = Exchange.MOST_OPEN;

    private final Pool pool;
    private final LiveState live;
    private final BodyList bodies;
    private final Busy busy;
    private final Exchange<CopiedState> exchange = new Exchange<>(CopiedState::new);
    private long steps;

    SharedView(Pool pool, LiveState live, BodyList bodies, Busy busy) {
        this.pool = pool;
        this.live = live;
        this.bodies = bodies;
        this.busy = busy;
        draw();
    }

    /**
     * Takes the newest picture, to be read by this thread alone and closed by it. Never waits.
     *
     * @throws IllegalStateException when {@link #MOST_OPEN} pictures are open, or the pool was
     *     closed since it was asked to share
     */
    public Picture read() {
        return new Picture(pool, exchange.take());
    }

    /**
     * Makes what was edited since the last step visible to readers. Only for the thread that uses
     * the pool.
     *
     * @throws IllegalStateException when called within a step, or when the pool was closed since it
     *     was asked to share
     */
    public void publish() {
        if (exchange.isClosed()) {
            throw new IllegalStateException("the pool was closed; ask Pool.shared() again");
        }
        busy.requireBetweenSteps("publish");
        draw();
    }

    /** A step has ended. */
    void stepped() {
        steps++;
        draw();
    }

    private void draw() {
        CopiedState picture = exchange.draw();
        picture.step = steps;
        picture.time = pool.time();
        picture.copy(live, bodies, pool.editedContacts());
        exchange.publish();
    }

    /** Number of copies that are kept. */
    int copies() {
        return exchange.pictures();
    }

    /** Refuses further readings; open pictures can still be read. */
    void end() {
        exchange.close();
    }
}
