package rigibo.backend.team;

import java.lang.ref.Cleaner;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.locks.LockSupport;

/**
 * A number of workers that share a piece of work: the thread that calls {@link #run}, and daemon
 * threads of the team's own, which are parked while there is nothing to do. Pieces of work follow
 * each other within microseconds in a step, so that waiting threads spin for a while before they
 * park.
 */
public final class Team implements AutoCloseable {

    /** Most workers of a team. */
    public static final int MOST = 64;

    /** How often a waiting thread looks before it parks, or lets others run. */
    private static final int SPINS = 1_000;

    private static final int IDLE = 0;
    private static final int OFFERED = 1;
    private static final int BUSY = 2;

    private final Thread[] threads;
    private final AtomicInteger taken = new AtomicInteger();

    /** What each of the threads does: nothing, or it is offered work, or at it. */
    private final AtomicIntegerArray states;

    private volatile boolean isClosed;
    private Shared work;
    private volatile Throwable failure;

    /** Made with the first team that has an owner. */
    private static final class Forgotten {
        static final Cleaner CLEANER = Cleaner.create();
    }

    /** A piece of work that workers share. */
    @FunctionalInterface
    public interface Shared {

        /** Does the share of one worker; number 0 is the thread that steps. */
        void run(int worker);
    }

    /** A team of a number of workers, 1 to {@link #MOST}, one of which is the caller. */
    public Team(int workers) {
        threads = new Thread[workers - 1];
        states = new AtomicIntegerArray(threads.length);
        for (int i = 0; i < threads.length; i++) {
            int worker = i + 1;
            threads[i] = new Thread(() -> serve(worker), "rigibo-worker-" + worker);
            threads[i].setDaemon(true);
            threads[i].start();
        }
    }

    /** Number of workers, with the calling thread. */
    public int size() {
        return threads.length + 1;
    }

    /**
     * Lets workers do their shares, and returns when all that began are done. A worker that has not
     * woken up when the caller is done does not begin, so that the caller alone must be able to do
     * all of the work. What the caller wrote before is seen by all workers, and what they wrote by
     * the caller.
     */
    public void run(Shared shared) {
        work = shared;
        failure = null;
        taken.set(0);
        for (int i = 0; i < threads.length; i++) {
            states.set(i, OFFERED);
            LockSupport.unpark(threads[i]);
        }
        share(0);
        for (int i = 0; i < threads.length; i++) {
            if (!states.compareAndSet(i, OFFERED, IDLE)) {
                for (int tries = 0; states.get(i) != IDLE; tries++) {
                    pause(tries);
                }
            }
        }
        work = null;
        if (failure != null) {
            throw new IllegalStateException("A worker of the pool failed", failure);
        }
    }

    /** A number that no other worker gets in this piece of work: 0, 1, 2 and so on. */
    public int next() {
        return taken.getAndIncrement();
    }

    private void share(int worker) {
        try {
            work.run(worker);
        } catch (Throwable thrown) {
            failure = thrown;
        }
    }

    private void serve(int worker) {
        int own = worker - 1;
        while (!isClosed) {
            for (int tries = 0; states.get(own) != OFFERED && !isClosed; tries++) {
                if (tries < SPINS) {
                    Thread.onSpinWait();
                } else {
                    LockSupport.park(this);
                }
            }
            if (states.compareAndSet(own, OFFERED, BUSY)) {
                share(worker);
                states.set(own, IDLE);
            }
        }
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

    /** Ends the team's own threads. */
    @Override
    public void close() {
        isClosed = true;
        for (Thread thread : threads) {
            LockSupport.unpark(thread);
        }
    }
}
