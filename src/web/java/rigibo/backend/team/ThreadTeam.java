package rigibo.backend.team;

/**
 * Stands in for the engine's {@code ThreadTeam} in a browser, which has no threads that share
 * memory. The caller does all pieces one after the other, so the bits are those of any number of
 * workers.
 */
public final class ThreadTeam implements Team {

    private final int size;
    private int splits;

    /** A team that claims a number of workers. */
    public ThreadTeam(int workers) {
        size = workers;
    }

    @Override
    public int size() {
        return size;
    }

    @Override
    public void split(int count, int grain, Pieces work) {
        splits++;
        for (int from = 0; from < count; from += grain) {
            work.run(from, Math.min(count, from + grain), 0);
        }
    }

    @Override
    public int takeSplits() {
        int since = splits;
        splits = 0;
        return since;
    }

    /** Does nothing: there is nothing to close. */
    public void closeWith(Object owner) {}

    @Override
    public void close() {}
}
