package rigibo.lab.problem;

import rigibo.lab.child.ThreadUse;

import java.util.function.LongSupplier;

/** What steps take, without what is done between those that are measured. */
public final class StepTally {

    private static final double NANOS_PER_MICRO = 1e3;

    private long steps;
    private long cpuNanos;
    private long wallNanos;
    private long bytes;

    /** Makes steps, of which {@code made} tells how many they were. */
    public void measure(LongSupplier made) {
        long wall = System.nanoTime();
        // The processor's clock may allocate, so bytes are counted within it.
        long cpu = ThreadUse.nanos();
        long allocated = ThreadUse.bytes();
        steps += made.getAsLong();
        bytes += ThreadUse.bytes() - allocated;
        cpuNanos += ThreadUse.nanos() - cpu;
        wallNanos += System.nanoTime() - wall;
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
