package rigibo.lab.problem;

import rigibo.lab.child.ThreadUse;

import java.util.function.LongSupplier;

/** The times of measured steps, without the work between them. */
public final class StepTally {

    private static final double NANOS_PER_MICRO = 1e3;

    private long steps;
    private long cpuNanos;
    private long wallNanos;
    private long bytes;

    /** Measures steps; {@code made} makes them and returns their number. */
    public void measure(LongSupplier made) {
        long wall = System.nanoTime();
        // Bytes are counted within the interval of the processor's clock, which may itself
        // allocate.
        long cpu = ThreadUse.nanos();
        long allocated = ThreadUse.bytes();
        steps += made.getAsLong();
        bytes += ThreadUse.bytes() - allocated;
        cpuNanos += ThreadUse.nanos() - cpu;
        wallNanos += System.nanoTime() - wall;
    }

    /** The number of measured steps. */
    public long steps() {
        return steps;
    }

    /** Mean processor time of the thread, µs a step. */
    public double cpuMicros() {
        return cpuNanos / (NANOS_PER_MICRO * steps);
    }

    /** Mean wall-clock time, µs a step. */
    public double wallMicros() {
        return wallNanos / (NANOS_PER_MICRO * steps);
    }

    /** Mean allocation, bytes a step. */
    public double bytesPerStep() {
        return (double) bytes / steps;
    }
}
