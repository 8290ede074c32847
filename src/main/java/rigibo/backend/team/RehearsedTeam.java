package rigibo.backend.team;

import java.util.function.LongSupplier;

/**
 * A team without threads: the caller does the pieces of all workers, and a clock tells what a core
 * for each of them would have spared. Pieces go to workers as they go in a team of threads, each
 * next one to the worker who is done first. Waking and waiting for threads costs nothing here, and
 * no memory travels from core to core, so that what is found is a bound for real teams.
 */
public final class RehearsedTeam implements Team {

    /** Returns ns. */
    private final LongSupplier clock;

    /** Time in ns after which each worker is done with what it took of the present work. */
    private final long[] busy;

    /** By worker, number of the pieces of its share that are taken. */
    private final int[] taken;

    private int splits;
    private long spared;

    /** A team of a number of workers, 1 to {@link #MOST}; the clock returns ns. */
    public RehearsedTeam(int workers, LongSupplier clock) {
        this.clock = clock;
        busy = new long[workers];
        taken = new int[workers];
    }

    @Override
    public int size() {
        return busy.length;
    }

    @Override
    public void split(int count, int grain, Pieces work) {
        splits++;
        int pieces = (count + grain - 1) / grain;
        int each = (pieces + size() - 1) / size();
        for (int worker = 0; worker < size(); worker++) {
            busy[worker] = 0;
            taken[worker] = 0;
        }
        Throwable failure = null;
        long before = clock.getAsLong();
        long present = before;
        for (int i = 0; i < pieces; i++) {
            int worker = firstDone();
            int from = takePiece(worker, each, pieces) * grain;
            try {
                work.run(from, Math.min(count, from + grain), worker);
            } catch (Throwable thrown) {
                failure = thrown;
            }
            long after = clock.getAsLong();
            busy[worker] += after - present;
            present = after;
        }
        long longest = 0;
        for (long time : busy) {
            longest = Math.max(longest, time);
        }
        spared += present - before - longest;
        if (failure != null) {
            throw new IllegalStateException("A worker of the pool failed", failure);
        }
    }

    /** The worker who is done first; of several, the first. */
    private int firstDone() {
        int first = 0;
        for (int worker = 1; worker < size(); worker++) {
            first = busy[worker] < busy[first] ? worker : first;
        }
        return first;
    }

    /** Takes a piece of a worker's share, or of the next one that has some; returns its number. */
    private int takePiece(int worker, int each, int pieces) {
        int share = worker;
        while (share * each + taken[share] >= pieces || taken[share] >= each) {
            share = (share + 1) % size();
        }
        return share * each + taken[share]++;
    }

    @Override
    public int takeSplits() {
        int since = splits;
        splits = 0;
        return since;
    }

    @Override
    public long takeSpared() {
        long since = spared;
        spared = 0;
        return since;
    }

    /** There is nothing to end. */
    @Override
    public void close() {}
}
