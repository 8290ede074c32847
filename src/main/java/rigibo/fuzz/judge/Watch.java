package rigibo.fuzz.judge;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Optional;

/**
 * What a thread does and since when, for another thread to look at. The time is the processor's,
 * which other programs on the machine do not take.
 */
public final class Watch {

    private static final double NANOS = 1e-9;

    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();

    /** Something that began on a thread, after so much of the processor's time. */
    private record Begun(String what, long thread, long nanos) {}

    private volatile Begun present = new Begun("nothing", Thread.currentThread().getId(), 0);

    /** The thread that calls begins with something else. */
    public void begins(String what) {
        long nanos = threads.getCurrentThreadCpuTime();
        present = new Begun(what, Thread.currentThread().getId(), nanos);
    }

    /** What has taken longer than so many seconds; a thread that has ended takes no time. */
    public Optional<String> overdue(double seconds) {
        Begun now = present;
        double taken = NANOS * (threads.getThreadCpuTime(now.thread()) - now.nanos());
        return taken > seconds ? Optional.of(now.what()) : Optional.empty();
    }
}
