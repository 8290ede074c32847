package rigibo.lab.bench.probe;

import com.sun.management.ThreadMXBean;

import java.lang.management.ManagementFactory;

/** Measures single steps on the thread that makes them. */
public final class StepMeter {

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private long nanos;
    private long bytes;

    /** Makes a step. The processor's clock may allocate, so bytes are counted within it. */
    public void measure(Stage stage) {
        long begun = THREADS.getCurrentThreadCpuTime();
        long allocated = THREADS.getCurrentThreadAllocatedBytes();
        stage.step();
        bytes = THREADS.getCurrentThreadAllocatedBytes() - allocated;
        nanos = THREADS.getCurrentThreadCpuTime() - begun;
    }

    /** Processor time of the last step, ns. */
    public long nanos() {
        return nanos;
    }

    /** Bytes that the last step allocated. */
    public long bytes() {
        return bytes;
    }
}
