package rigibo.backend;

import com.sun.management.ThreadMXBean;

import java.lang.management.ManagementFactory;

/** Measures what a piece of work allocates once it is warm. */
public final class Allocation {

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private Allocation() {}

    /** Bytes that the work allocates when it is done for the third time. */
    public static long ofThirdRun(Runnable work) {
        work.run();
        // Asking allocates too, the first time.
        bytes();
        work.run();
        long before = bytes();
        work.run();
        return bytes() - before;
    }

    /** Bytes that this thread has allocated so far. */
    static long bytes() {
        return THREADS.getThreadAllocatedBytes(Thread.currentThread().getId());
    }
}
