package rigibo.lab.problem;

import com.sun.management.ThreadMXBean;

import java.lang.management.ManagementFactory;
import java.util.function.LongSupplier;

/** What steps take, without what is done between those that are measured. */
public final class StepTally {

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final double NANOS_PER_MICRO = 1e3;

    private long steps;
    private long cpuNanos;
    private long wallNanos;
    private long bytes;

    /** Makes steps, of which {@code made} tells how many they were. */
    public void measure(LongSupplier made) {
        long wall = System.nanoTime();
        // The processor's clock may allocate, so bytes are counted within it.
        long cpu = processorNanos();
        long allocated = THREADS.getCurrentThreadAllocatedBytes();
        steps += made.getAsLong();
        bytes += THREADS.getCurrentThreadAllocatedBytes() - allocated;
        cpuNanos += processorNanos() - cpu;
        wallNanos += System.nanoTime() - wall;
    }

    /** What this thread has used of a processor: others that are given turns do not count. */
    private static long processorNanos() {
        return THREADS.isCurrentThreadCpuTimeSupported()
                ? THREADS.getCurrentThreadCpuTime()
                : System.nanoTime();
    }

    /** Steps that were measured. */
    public long steps() {
        return steps;
    }

    /** Mean of the thread's own processor time, µs a step. */
    public double cpuMicros() {
        return cpuNanos / (NANOS_PER_MICRO * steps);
    }

    /** Mean by the clock on the wall, µs a step. */
    public double wallMicros() {
        return wallNanos / (NANOS_PER_MICRO * steps);
    }

    /** Mean of what is allocated, bytes a step. */
    public double bytesPerStep() {
        return (double) bytes / steps;
    }
}
