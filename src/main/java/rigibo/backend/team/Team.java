package rigibo.backend.team;

/** Workers that share pieces of work. The calling thread is one of them. */
public interface Team extends AutoCloseable {

    /** Most workers of a team. */
    int MOST = 64;

    /** Work on a range of numbers, no part of which depends on another. */
    @FunctionalInterface
    interface Pieces {

        /**
         * Does the work from one number up to another, which is excluded.
         *
         * @param worker number of the worker; 0 is the thread that steps
         */
        void run(int from, int to, int worker);
    }

    /** Number of workers, the calling thread included. */
    int size();

    /**
     * Does work on the numbers from 0 to {@code count}, excluded, in pieces of {@code grain}
     * numbers, and returns when all of it is done. Each worker begins with a share of its own. For
     * equal counts shares are equal, so that a worker finds its data in its processor's cache. A
     * worker that has finished its share takes pieces of others, so that a sleeping thread delays
     * nothing. Workers see what the caller wrote before the call, and afterwards the caller sees
     * what they wrote.
     *
     * @throws IllegalStateException when a piece threw an exception, which is the cause
     */
    void split(int count, int grain, Pieces work);

    /** Number of times that work was split since the last call. */
    int takeSplits();

    /**
     * Time in ns that a core for each worker would have saved since the last call; 0 for a team of
     * threads.
     */
    default long takeSpared() {
        return 0;
    }

    /** Ends the team's own threads. */
    @Override
    void close();
}
