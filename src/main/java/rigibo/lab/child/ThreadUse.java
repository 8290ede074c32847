package rigibo.lab.child;

import com.sun.management.ThreadMXBean;

import java.lang.management.ManagementFactory;

/** What the thread that asks has used since it began: what others are given does not count. */
public final class ThreadUse {

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private ThreadUse() {}

    /** Processor time, ns; that of the wall where the system does not tell. It may allocate. */
    public static long nanos() {
        return THREADS.isCurrentThreadCpuTimeSupported()
                ? THREADS.getCurrentThreadCpuTime()
                : System.nanoTime();
    }

    /** Of the heap, bytes. */
    public static long bytes() {
        return THREADS.getCurrentThreadAllocatedBytes();
    }
}
