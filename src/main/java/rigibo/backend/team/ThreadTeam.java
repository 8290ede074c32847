package rigibo.backend.team;

import java.lang.ref.Cleaner;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.locks.LockSupport;

/**
 * A team of the thread that calls {@link #split} and daemon threads of its own. Pieces follow each
 * other within microseconds in a step, so that threads without work spin for a while before they
 * park, and nobody waits for one that is parked.
 */
public final class ThreadTeam implements Team {

    /** How often a thread without work looks for some before it parks or yields. */
    private static final int SPINS = 1_000;

    private static final int AWAKE = 0;
    private static final int PARKED = 1;

    /**
     * Bits of a share's word that hold the number of its pieces, and as many for the pieces taken.
     */
    private static final int PIECE_BITS = 20;

    private static final int MOST_PIECES = (1 << PIECE_BITS) - 1;

    /**
     * Distance between two shares: two cache lines, so that workers do not write to the same one.
     */
    private static final int APART = 16;

    private final Thread[] threads;
    private final AtomicIntegerArray states;

    /** Number of the present work. */
    private final AtomicLong number = new AtomicLong();

    /**
     * By worker: the number of the present work, how many pieces its share has, and how many of
     * them are taken. One word holds all three, so that a piece that is taken surely belongs to the
     * present work.
     */
    private final AtomicLongArray shares;

    /** Number of pieces that are done. */
    private final AtomicInteger done = new AtomicInteger();

    private volatile boolean isClosed;
    private volatile Throwable failure;
    private int splits;
    private Pieces work;
    private int count;
    private int grain;

    /** Loaded with the first team that has an owner. */
    private static final class Forgotten {
        static final Cleaner CLEANER = Cleaner.create();
    }

    /** A team of a number of workers, 1 to {@link #MOST}, one of which is the caller. */
    public ThreadTeam(int workers) {
        threads = new Thread[workers - 1];
        states = new AtomicIntegerArray(threads.length);
        shares = new AtomicLongArray(APART * workers);
        for (int i = 0; i < threads.length; i++) {
            int worker = i + 1;
            threads[i] = new Thread(() -> serve(worker), "rigibo-worker-" + worker);
            threads[i].setDaemon(true);
            threads[i].start();
        }
    }

    @Override
    public int size() {
        return threads.length + 1;
    }

    @Override
    public void split(int count, int grain, Pieces work) {
        splits++;
        int size = Math.max(grain, count / MOST_PIECES + 1);
        int pieces = (count + size - 1) / size;
        int each = (pieces + size() - 1) / size();
        this.work = work;
        this.count = count;
        this.grain = size;
        failure = null;
        done.set(0);
        long present = number.get() + 1;
        for (int worker = 0; worker < size(); worker++) {
            shares.set(APART * worker, present << 2 * PIECE_BITS | (long) each << PIECE_BITS);
        }
        number.set(present);
        wake(pieces - 1);
        takePieces(0);
        for (int tries = 0; done.get() < each * size(); tries++) {
            pause(tries);
        }
        if (failure != null) {
            throw new IllegalStateException("A worker of the pool failed", failure);
        }
    }

    @Override
    public int takeSplits() {
        int since = splits;
        splits = 0;
        return since;
    }

    /** Wakes as many parked threads as there may be pieces for. */
    private void wake(int most) {
        for (int i = 0; i < threads.length && i < most; i++) {
            if (states.get(i) == PARKED && states.compareAndSet(i, PARKED, AWAKE)) {
                LockSupport.unpark(threads[i]);
            }
        }
    }

    /** Does the pieces of a worker's own share, then those that others have not begun. */
    private void takePieces(int worker) {
        for (int i = 0; i < size(); i++) {
            int share = (worker + i) % size();
            while (takePiece(share, worker)) {
                // Ends when no piece of this share is left.
            }
        }
    }

    /** Takes a piece of a share and does it; returns whether one was left. */
    private boolean takePiece(int share, int worker) {
        long seen = shares.get(APART * share);
        int taken = (int) seen & MOST_PIECES;
        int each = (int) (seen >>> PIECE_BITS) & MOST_PIECES;
        if (taken >= each) {
            return false;
        }
        // The work's description does not change while one of its pieces is not taken.
        if (shares.compareAndSet(APART * share, seen, seen + 1)) {
            int from = Math.min(count, (share * each + taken) * grain);
            int to = Math.min(count, from + grain);
            try {
                work.run(from, to, worker);
            } catch (Throwable thrown) {
                failure = thrown;
            }
            done.getAndIncrement();
        }
        return true;
    }

    private void serve(int worker) {
        long last = 0;
        int tries = 0;
        while (!isClosed) {
            long present = number.get();
            if (present != last) {
                last = present;
                tries = 0;
                takePieces(worker);
            } else if (tries++ < SPINS) {
                Thread.onSpinWait();
            } else {
                park(worker - 1, last);
                tries = 0;
            }
        }
    }

    /** Parks until there is other work than the last. */
    private void park(int own, long last) {
        states.set(own, PARKED);
        // Looks again: work that arrived just before this thread was marked as parked would wake
        // nobody.
        while (states.get(own) == PARKED && number.get() == last && !isClosed) {
            LockSupport.park(this);
        }
        states.set(own, AWAKE);
    }

    private static void pause(int tries) {
        if (tries < SPINS) {
            Thread.onSpinWait();
        } else {
            Thread.yield();
        }
    }

    /** Closes the team when nothing refers to an object any more. */
    public void closeWith(Object owner) {
        Forgotten.CLEANER.register(owner, this::close);
    }

    @Override
    public void close() {
        isClosed = true;
        for (Thread thread : threads) {
            LockSupport.unpark(thread);
        }
    }
}
