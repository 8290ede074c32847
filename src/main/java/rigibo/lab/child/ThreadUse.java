package rigibo.lab.child;

import com.sun.management.ThreadMXBean;

import java.lang.management.ManagementFactory;

/** What the calling thread has used since it started; other threads do not count. */
public final class ThreadUse {

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private ThreadUse() {}

    /** Processor time in ns, or wall-clock time if that is unknown. The call may allocate. */
    public static long nanos() {
        return THREADS.isCurrentThreadCpuTimeSupported()
                ? THREADS.getCurrentThreadCpuTime()
                : System.nanoTime();
    }

    /** Bytes allocated on the heap. */
    public static long bytes() {
        return THREADS.getCurrentThreadAllocatedBytes();
    }
}
