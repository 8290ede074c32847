package rigibo.lab.hardcase;

import com.sun.management.ThreadMXBean;

import java.lang.management.ManagementFactory;

/** What this thread takes of the heap. */
final class Heap {

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private Heap() {}

    /** Bytes that this thread has allocated since it began. */
    static long allocated() {
        return THREADS.getCurrentThreadAllocatedBytes();
    }
}
