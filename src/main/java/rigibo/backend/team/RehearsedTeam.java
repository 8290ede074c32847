package rigibo.backend.team;

import java.util.function.LongSupplier;

/**
 * A team without threads. The caller does the pieces of all workers, and a clock tells how much
 * time a core for each of them would have saved. Pieces are handed out as in a team of threads: the
 * next one goes to the worker that is done first. A real team saves less, since its threads have to
 * wake up and wait, and memory moves from core to core.
 */
public final class RehearsedTeam implements Team {

    /** Returns ns. */
    private final LongSupplier clock;

    /**
     * By worker, time in ns at which it would be done with the pieces it took of the present work.
     */
    private final long[] busy;

    /** By worker, number of pieces taken from its share. */
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

    /** The worker that is done first; of several, the one with the lowest number. */
    private int firstDone() {
        int first = 0;
        for (int worker = 1; worker < size(); worker++) {
            first = busy[worker] < busy[first] ? worker : first;
        }
        return first;
    }

    /**
     * Takes a piece of a worker's share, or of the next share that has any left; returns its
     * number.
     */
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
