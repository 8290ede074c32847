package rigibo.backend.team;

/**
 * What the engine's {@code Team} is in a browser, which has no threads that share memory: the
 * caller does every piece, one after the other, and so the bits are those of any number of workers.
 */
public final class Team implements AutoCloseable {

    /** Most workers of a team. */
    public static final int MOST = 64;

    private final int size;
    private int splits;

    /** Work on a range of numbers, of which no part depends on another. */
    @FunctionalInterface
    public interface Pieces {

        /** Does the work from one number up to another, which is excluded. */
        void run(int from, int to, int worker);
    }

    /** A team that says it has so many workers. */
    public Team(int workers) {
        size = workers;
    }

    /** Number of workers that were asked for. */
    public int size() {
        return size;
    }

    /** Does work on the numbers from 0 to {@code count}, excluded, in pieces of {@code grain}. */
    public void split(int count, int grain, Pieces work) {
        splits++;
        for (int from = 0; from < count; from += grain) {
            work.run(from, Math.min(count, from + grain), 0);
        }
    }

    /** Number of times that work was split since the last call. */
    public int takeSplits() {
        int since = splits;
        splits = 0;
        return since;
    }

    /** There is nothing to close. */
    public void closeWith(Object owner) {}

    @Override
    public void close() {}
}
