package rigibo.lab.problem;

import com.sun.management.ThreadMXBean;

import java.lang.management.ManagementFactory;

/** What steps take, one by one, so that what is looked at between them does not count. */
public final class StepTally {

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final double NANOS_PER_MICRO = 1e3;

    private long steps;
    private long cpuNanos;
    private long wallNanos;
    private long bytes;

    /** Makes a step. The processor's clock may allocate, so bytes are counted within it. */
    void measure(Runnable step) {
        long wall = System.nanoTime();
        long cpu = THREADS.getCurrentThreadCpuTime();
        long allocated = THREADS.getCurrentThreadAllocatedBytes();
        step.run();
        bytes += THREADS.getCurrentThreadAllocatedBytes() - allocated;
        cpuNanos += THREADS.getCurrentThreadCpuTime() - cpu;
        wallNanos += System.nanoTime() - wall;
        steps++;
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
