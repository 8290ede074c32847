package rigibo.backend.team;

/** A number of workers that share pieces of work; one of them is the thread that asks them to. */
public interface Team extends AutoCloseable {

    /** Most workers of a team. */
    int MOST = 64;

    /** Work on a range of numbers, of which no part depends on another. */
    @FunctionalInterface
    interface Pieces {

        /**
         * Does the work from one number up to another, which is excluded.
         *
         * @param worker who does it; 0 is the thread that steps
         */
        void run(int from, int to, int worker);
    }

    /** Number of workers, with the calling thread. */
    int size();

    /**
     * Does work on the numbers from 0 to {@code count}, excluded, in pieces of {@code grain}
     * numbers, and returns when all of it is done. Each worker has a share of its own, a range that
     * is the same whenever the count is, so that its processor still has in its cache what it
     * worked on before; who is done with it takes pieces of others, so that a thread that is asleep
     * delays nothing. What the caller wrote before is seen by all workers, and what they wrote by
     * the caller.
     *
     * @throws IllegalStateException when a piece threw, which is its cause
     */
    void split(int count, int grain, Pieces work);

    /** Number of times that work was split since the last call. */
    int takeSplits();

    /** Time in ns that a core for each worker would have spared since the last call; else 0. */
    default long takeSpared() {
        return 0;
    }

    /** Ends the team's own threads. */
    @Override
    void close();
}
