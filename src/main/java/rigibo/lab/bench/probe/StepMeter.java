package rigibo.lab.bench.probe;

import rigibo.lab.child.ThreadUse;

/** Measures single steps on the thread that makes them. */
public final class StepMeter {

    private long nanos;
    private long bytes;

    /** Makes a step. The clock may allocate, so bytes are counted within its interval. */
    public void measure(Stage stage) {
        long begun = ThreadUse.nanos();
        long allocated = ThreadUse.bytes();
        stage.step();
        bytes = ThreadUse.bytes() - allocated;
        nanos = ThreadUse.nanos() - begun;
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
